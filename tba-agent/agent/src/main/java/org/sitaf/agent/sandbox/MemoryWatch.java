package org.sitaf.agent.sandbox;

import java.time.Duration;
import java.util.concurrent.TimeUnit;
import org.sitaf.agent.sandbox.cgroup.ControlGroup;

/**
 * Kills a process that, with all that it started, uses more memory than allowed. Asks the control
 * group, or measures the processes if there is none.
 */
final class MemoryWatch implements Runnable {
  private static final Duration PERIOD = Duration.ofMillis(100);

  /** Without a control group: memory may grow fast between two measurements. */
  private static final Duration SHORTEST = Duration.ofMillis(20);

  private static final int PAUSE_FACTOR = 10;

  private final Process process;
  private final ControlGroup group;
  private final int limitMiB;
  private final Runnable onExcess;
  private final Runnable onEnd;

  private MemoryWatch(
      Process process, ControlGroup group, int limitMiB, Runnable onExcess, Runnable onEnd) {
    this.process = process;
    this.group = group;
    this.limitMiB = limitMiB;
    this.onExcess = onExcess;
    this.onEnd = onEnd;
  }

  /**
   * Watches until the process ends.
   *
   * @param onEnd called after the process has ended for whatever reason
   */
  static void start(
      Process process, ControlGroup group, int limitMiB, Runnable onExcess, Runnable onEnd) {
    Thread thread =
        new Thread(new MemoryWatch(process, group, limitMiB, onExcess, onEnd), "sitaf-memory");
    thread.setDaemon(true);
    thread.start();
  }

  @Override
  public void run() {
    try {
      long pause = group.limitsMemory() ? PERIOD.toMillis() : SHORTEST.toMillis();
      while (!process.waitFor(pause, TimeUnit.MILLISECONDS)) {
        long before = System.nanoTime();
        if (isExceeded()) {
          onExcess.run();
          break;
        }
        long elapsedMs = Duration.ofNanos(System.nanoTime() - before).toMillis();
        if (!group.limitsMemory()) {
          pause = Math.max(SHORTEST.toMillis(), PAUSE_FACTOR * elapsedMs);
        }
      }
      process.waitFor();
      onEnd.run();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private boolean isExceeded() {
    return group.limitsMemory()
        ? group.exceededMemory()
        : MemoryUse.kibOf(process.pid()) > (long) limitMiB << 10;
  }
}
