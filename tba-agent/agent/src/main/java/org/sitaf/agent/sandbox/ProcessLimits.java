package org.sitaf.agent.sandbox;

import java.time.Duration;
import java.util.Objects;
import org.sitaf.agent.sandbox.cgroup.GroupLimits;

/**
 * Limits of a process and all that it starts.
 *
 * @param memoryMiB memory, including the language runtime
 * @param processes processes and threads at a time
 * @param fileMiB size of a single file
 * @param cpu processor time of each process
 * @param reservesMemory whether the process reserves address space far beyond what it uses, as a
 *     sanitizer does for its shadow memory; then only its use of memory is limited
 */
public record ProcessLimits(
    int memoryMiB, int processes, int fileMiB, Duration cpu, boolean reservesMemory) {
  /** The limits of a compiler. */
  public static final ProcessLimits TOOL =
      new ProcessLimits(2048, 256, 1024, Duration.ofMinutes(10));

  /** More than the shadow memory of ThreadSanitizer, which is most of the 128 TiB of a process. */
  private static final long RESERVED_BYTES = 128L << 40;

  public ProcessLimits {
    Objects.requireNonNull(cpu);
    if (memoryMiB < 1 || processes < 1 || fileMiB < 1 || cpu.isZero() || cpu.isNegative()) {
      throw new IllegalArgumentException("limits must be positive");
    }
  }

  /** The limits of a process that reserves little more memory than it uses. */
  public ProcessLimits(int memoryMiB, int processes, int fileMiB, Duration cpu) {
    this(memoryMiB, processes, fileMiB, cpu, false);
  }

  /**
   * Address space limit of a single process ({@code RLIMIT_DATA}). Runtimes reserve more than they
   * use, so this only stops processes that grow faster than {@link MemoryWatch} measures.
   */
  long dataBytes() {
    return reservesMemory ? RESERVED_BYTES : (2L * memoryMiB + 1024) << 20;
  }

  /**
   * The same limits for a control group, with an allowance for what it counts in addition: kernel
   * memory of the processes, and bubblewrap itself.
   */
  GroupLimits ofGroup() {
    long bytes = (long) memoryMiB << 20;
    return new GroupLimits(bytes + bytes / 16 + (16L << 20), processes + 4);
  }

  long cpuSeconds() {
    return Math.max(1, cpu.toSeconds());
  }
}
