package org.sitaf.agent.sandbox.cgroup;

/**
 * Limits of all processes of a group.
 *
 * @param memoryBytes all memory, including kernel memory; the kernel reclaims its file cache before
 *     the limit takes effect
 * @param processes processes and threads at a time
 */
public record GroupLimits(long memoryBytes, int processes) {
  public GroupLimits {
    if (memoryBytes < 1 || processes < 1) {
      throw new IllegalArgumentException("limits must be positive");
    }
  }
}
