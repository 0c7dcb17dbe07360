package org.sitaf.agent.sandbox;

import java.io.IOException;
import java.util.List;

/**
 * A Landlock domain for the processes of a sandbox. Bubblewrap's first process reports their exit
 * code and, if the agent is not root, has their user. A process in a domain cannot read or change
 * processes outside of it, and since Linux 6.12 it cannot send signals to them either.
 *
 * <p>Java cannot make the system calls between fork and exec; Perl, a part of each Debian system,
 * can in 2 ms.
 */
final class LandlockDomain {
  /**
   * Enters a domain and starts the command. A ruleset must take away an access: the domain denies
   * moving files between folders (later versions) or making block devices (first version), and
   * allows the former again everywhere. Numbers of system calls are the same on all architectures;
   * the constants are those of {@code linux/landlock.h}.
   */
  private static final String SCRIPT =
      """
      sub checked { my ($what, $result) = @_; $result >= 0 or die "cannot $what: $!\\n"; $result }
      my $version = checked("use Landlock", syscall(444, 0, 0, 1));
      my $access = $version >= 2 ? 1 << 13 : 1 << 11;
      my $attributes = pack($version >= 6 ? "QQQ" : "Q", $access, 0, 2);
      my $rules = checked("create a ruleset", syscall(444, $attributes, length($attributes), 0));
      if ($version >= 2) {
        sysopen(my $root, "/", 010000000) or die "cannot open /: $!\\n";
        my $rule = pack("Ql", $access, fileno($root));
        checked("add a rule", syscall(445, $rules, 1, $rule, 0));
      }
      checked("enter a domain", syscall(446, $rules, 0));
      exec { $ARGV[0] } @ARGV or die "cannot start $ARGV[0]: $!\\n";
      """;

  private static final List<String> ENTER = List.of("perl", "-e", SCRIPT, "--");

  private LandlockDomain() {}

  /** Prefix of a command that is to run in a domain of its own, without new privileges. */
  static List<String> enter() {
    return ENTER;
  }

  /** Why a command does not work in a domain on this machine; empty if it does. */
  static String missing(Trial trial) {
    try {
      trial.run(ENTER);
      return "";
    } catch (IOException e) {
      return String.valueOf(e.getMessage());
    }
  }

  /** Runs a trial command with a prefix, in a sandbox. */
  @FunctionalInterface
  interface Trial {
    /**
     * @throws IOException if the command does not succeed, with its output
     */
    void run(List<String> prefix) throws IOException;
  }
}
