package org.sitaf.agent.sandbox.cgroup;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/**
 * The kernel's own groups, one for each session, which share the processors out where they are
 * switched on and the processes are in no control group that does.
 */
public final class AutomaticGroups {
  private static final Path SWITCH = Path.of("/proc/sys/kernel/sched_autogroup_enabled");
  private static final Path OWN = Path.of("/proc/self/cgroup");
  private static final String UNIFIED = "0::";

  private AutomaticGroups() {}

  /** Whether what this process starts has its share by session. */
  public static boolean shareProcessors() {
    try {
      return Files.readString(SWITCH).strip().equals("1")
          && isInNoGroupFor("cpu", Files.readAllLines(OWN));
    } catch (IOException e) {
      return false;
    }
  }

  /** With version 2 alone, systemd shares the processors out between the groups below its root. */
  static boolean isInNoGroupFor(String controller, List<String> memberships) {
    for (String membership : memberships) {
      String[] parts = membership.split(":", 3);
      if (parts.length == 3 && List.of(parts[1].split(",")).contains(controller)) {
        return parts[2].equals("/");
      }
    }
    return memberships.stream()
        .filter(membership -> membership.startsWith(UNIFIED))
        .allMatch(membership -> membership.equals(UNIFIED + "/"));
  }
}
