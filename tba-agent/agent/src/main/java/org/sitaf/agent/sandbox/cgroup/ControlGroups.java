package org.sitaf.agent.sandbox.cgroup;

import java.io.IOException;

/** Makes groups for confined processes, as far as this machine allows it. Safe for threads. */
public sealed interface ControlGroups permits VersionOne, VersionTwo, NoControlGroups {
  /** The controllers that are used, in this order of importance. */
  java.util.List<String> CONTROLLERS = java.util.List.of("memory", "pids", "cpu");

  /** What they bind, for logs; or why there are none. */
  String description();

  /** Whether the kernel counts and bounds all memory of a group. */
  boolean bindMemory();

  /** Whether the kernel shares the processors out by groups. */
  boolean shareProcessors();

  /** Makes a group; {@link ControlGroup#NONE} where this machine has none. */
  ControlGroup make(GroupLimits limits) throws IOException;

  /**
   * Those of this machine, tried out; what agents left that are gone is removed. The same ones for
   * the whole life of this process.
   */
  static ControlGroups ofThisMachine() {
    return ThisMachine.groups();
  }

  /** None. */
  static ControlGroups none(String reason) {
    return new NoControlGroups(reason);
  }
}
