package org.sitaf.agent.sandbox.cgroup;

/**
 * What the processes of a group may use together.
 *
 * @param memoryBytes memory of any kind, the kernel's for them included; what can be dropped (files
 *     that were read) is dropped before it counts
 * @param processes processes and threads at a time
 */
public record GroupLimits(long memoryBytes, int processes) {
  public GroupLimits {
    if (memoryBytes < 1 || processes < 1) {
      throw new IllegalArgumentException("limits must be above 0");
    }
  }
}
