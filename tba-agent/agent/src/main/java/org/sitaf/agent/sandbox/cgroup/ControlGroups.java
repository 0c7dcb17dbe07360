package org.sitaf.agent.sandbox.cgroup;

import java.io.IOException;

/** Creates control groups for confined processes, as far as this machine allows it. Thread-safe. */
public sealed interface ControlGroups permits VersionOne, VersionTwo, NoControlGroups {
  /** The controllers in use, the most important first. */
  java.util.List<String> CONTROLLERS = java.util.List.of("memory", "pids", "cpu");

  /** The controllers in use, for logs; or the reason why there are none. */
  String description();

  /** Whether the kernel counts and limits all memory of a group. */
  boolean limitsMemory();

  /** Whether the kernel distributes processor time among the groups. */
  boolean sharesCpu();

  /** Creates a group; {@link ControlGroup#NONE} if this machine has none. */
  ControlGroup create(GroupLimits limits) throws IOException;

  /**
   * The control groups of this machine, probed once per process. Groups of agents that no longer
   * run are removed.
   */
  static ControlGroups ofThisMachine() {
    return ControlGroupProbe.groups();
  }

  /** No control groups. */
  static ControlGroups none(String reason) {
    return new NoControlGroups(reason);
  }
}
