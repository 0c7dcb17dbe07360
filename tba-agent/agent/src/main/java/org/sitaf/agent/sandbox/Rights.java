package org.sitaf.agent.sandbox;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** The commands before a command that limit what it may use and take its rights away. */
final class Rights {
  private static final Path LIMITS = Path.of("/proc/self/limits");

  /** A line of {@link #LIMITS}: name, soft limit, hard limit. */
  private static final Pattern LINE = Pattern.compile("(Max .*?)\\s{2,}(\\S+)\\s+(\\S+)\\s.*");

  private static final int FILES = 4096;
  private static final int SIGNALS = 1024;
  private static final int LOCKED_BYTES = 64 << 10;
  private static final int MESSAGE_BYTES = 800 << 10;

  private final Map<String, Long> highest = new HashMap<>();

  private Rights() {}

  /** As this process may give them away: nobody but root raises a limit. */
  static Rights ofThisProcess() throws IOException {
    Rights rights = new Rights();
    for (String line : Files.readAllLines(LIMITS)) {
      Matcher matcher = LINE.matcher(line);
      if (matcher.matches() && !matcher.group(3).equals("unlimited")) {
        rights.highest.put(matcher.group(1), Long.parseLong(matcher.group(3)));
      }
    }
    return rights;
  }

  /** Limits of the kernel for each process, and for all of its user. */
  List<String> limit(ProcessLimits limits) {
    return List.of(
        "prlimit",
        "--core=0",
        "--rtprio=0",
        "--nofile=" + atMost("Max open files", FILES),
        "--nproc=" + atMost("Max processes", limits.processes()),
        "--fsize=" + atMost("Max file size", (long) limits.fileMiB() << 20),
        "--data=" + atMost("Max data size", limits.dataBytes()),
        "--cpu=" + atMost("Max cpu time", limits.cpuSeconds()),
        "--memlock=" + atMost("Max locked memory", LOCKED_BYTES),
        "--sigpending=" + atMost("Max pending signals", SIGNALS),
        "--msgqueue=" + atMost("Max msgqueue size", MESSAGE_BYTES),
        "--");
  }

  /** Root becomes somebody who owns nothing. */
  static List<String> become(int user) {
    return List.of(
        "setpriv",
        "--reuid=" + user,
        "--regid=" + user,
        "--clear-groups",
        "--inh-caps=-all",
        "--bounding-set=-all",
        "--no-new-privs",
        "--");
  }

  /**
   * A command with variables that it alone sees. Those before it, bubblewrap among them, have more
   * rights and must not be made to load its libraries.
   */
  static List<String> with(Map<String, String> variables, List<String> command) {
    if (variables.isEmpty()) {
      return command;
    }
    List<String> words = new ArrayList<>(List.of("env", "--"));
    variables.forEach((name, value) -> words.add(name + "=" + value));
    if (command.get(0).contains("=")) {
      // Else it would be taken for a variable.
      words.addAll(List.of("sh", "-c", "exec \"$@\"", "sh"));
    }
    words.addAll(command);
    return words;
  }

  private long atMost(String name, long wanted) {
    return Math.min(wanted, Optional.ofNullable(highest.get(name)).orElse(Long.MAX_VALUE));
  }
}
