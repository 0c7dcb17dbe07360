package org.sitaf.agent.sandbox;

/**
 * What a process and all that it starts may use together.
 *
 * @param memoryMiB resident memory, libraries and runtime included
 * @param processes processes and threads at a time
 * @param fileMiB size of each file that it writes
 */
public record ProcessLimits(int memoryMiB, int processes, int fileMiB) {
  /** What a compiler may use. */
  public static final ProcessLimits TOOL = new ProcessLimits(2048, 256, 1024);

  public ProcessLimits {
    if (memoryMiB < 1 || processes < 1 || fileMiB < 1) {
      throw new IllegalArgumentException("limits must be above 0");
    }
  }
}
