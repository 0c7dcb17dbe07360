package org.sitaf.agent.sandbox;

import java.time.Duration;
import java.util.Objects;
import org.sitaf.agent.sandbox.cgroup.GroupLimits;

/**
 * What a process and all that it starts may use together.
 *
 * @param memoryMiB memory of its own, that of its language's runtime included
 * @param processes processes and threads at a time
 * @param fileMiB size of each file that it writes
 * @param cpu processor time of each process
 */
public record ProcessLimits(int memoryMiB, int processes, int fileMiB, Duration cpu) {
  /** What a compiler may use. */
  public static final ProcessLimits TOOL =
      new ProcessLimits(2048, 256, 1024, Duration.ofMinutes(10));

  public ProcessLimits {
    Objects.requireNonNull(cpu);
    if (memoryMiB < 1 || processes < 1 || fileMiB < 1 || cpu.isZero() || cpu.isNegative()) {
      throw new IllegalArgumentException("limits must be above 0");
    }
  }

  /**
   * What one process may ask for at all. Runtimes ask for more than they use, so this only stops
   * what grows faster than {@link MemoryWatch} looks.
   */
  long dataBytes() {
    return (2L * memoryMiB + 1024) << 20;
  }

  /**
   * The same for a control group, which counts more: the kernel's tables and stacks for the
   * processes, and bubblewrap's own.
   */
  GroupLimits ofGroup() {
    long bytes = (long) memoryMiB << 20;
    return new GroupLimits(bytes + bytes / 16 + (16L << 20), processes + 4);
  }

  long cpuSeconds() {
    return Math.max(1, cpu.toSeconds());
  }
}
