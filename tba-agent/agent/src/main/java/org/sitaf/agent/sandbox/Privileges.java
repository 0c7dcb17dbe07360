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

/** Command prefixes that set limits and drop privileges. */
final class Privileges {
  private static final Path LIMITS = Path.of("/proc/self/limits");

  /** A line of {@link #LIMITS}: name, soft limit, hard limit. */
  private static final Pattern LINE = Pattern.compile("(Max .*?)\\s{2,}(\\S+)\\s+(\\S+)\\s.*");

  private static final int FILES = 4096;
  private static final int SIGNALS = 1024;
  private static final int LOCKED_BYTES = 64 << 10;
  private static final int MESSAGE_BYTES = 800 << 10;

  private final Map<String, Long> hardLimits = new HashMap<>();

  private Privileges() {}

  /** Reads the limits of this process, which only root could exceed. */
  static Privileges ofThisProcess() throws IOException {
    Privileges privileges = new Privileges();
    for (String line : Files.readAllLines(LIMITS)) {
      Matcher matcher = LINE.matcher(line);
      if (matcher.matches() && !matcher.group(3).equals("unlimited")) {
        privileges.hardLimits.put(matcher.group(1), Long.parseLong(matcher.group(3)));
      }
    }
    return privileges;
  }

  /** Limits of each process; the number of processes counts for the whole user. */
  List<String> setLimits(ProcessLimits limits) {
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

  /** Switches from root to an unprivileged user. */
  static List<String> switchTo(int user) {
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
   * Sets variables for the command only. Programs before it, such as bubblewrap, have more
   * privileges and must not load libraries named by these variables.
   */
  static List<String> withVariables(Map<String, String> variables, List<String> command) {
    if (variables.isEmpty()) {
      return command;
    }
    List<String> words = new ArrayList<>(List.of("env", "--"));
    variables.forEach((name, value) -> words.add(name + "=" + value));
    if (command.get(0).contains("=")) {
      // Otherwise env would take it for a variable.
      words.addAll(List.of("sh", "-c", "exec \"$@\"", "sh"));
    }
    words.addAll(command);
    return words;
  }

  private long atMost(String name, long wanted) {
    return Math.min(wanted, Optional.ofNullable(hardLimits.get(name)).orElse(Long.MAX_VALUE));
  }
}
