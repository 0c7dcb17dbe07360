package org.sitaf.agent.sandbox.cgroup;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/**
 * The scheduler's autogroup feature, which gives each session the same share of the processors
 * unless the processes are in a control group of the {@code cpu} controller.
 */
public final class AutomaticGroups {
  private static final Path SWITCH = Path.of("/proc/sys/kernel/sched_autogroup_enabled");
  private static final Path OWN = Path.of("/proc/self/cgroup");
  private static final String UNIFIED = "0::";

  private AutomaticGroups() {}

  /** Whether the sessions that this process starts get equal shares. */
  public static boolean sharesCpu() {
    try {
      return Files.readString(SWITCH).strip().equals("1")
          && isInNoGroupFor("cpu", Files.readAllLines(OWN));
    } catch (IOException e) {
      return false;
    }
  }

  /** In a system with version 2 only, systemd distributes processor time among its groups. */
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
