package org.sitaf.agent.sandbox;

import java.time.Duration;
import java.util.concurrent.TimeUnit;
import org.sitaf.agent.sandbox.cgroup.ControlGroup;

/**
 * Ends a process that uses, with all that it started, more memory than it may: the kernel says it
 * of the process's control group; without one its processes are looked at.
 */
final class MemoryWatch implements Runnable {
  private static final Duration PERIOD = Duration.ofMillis(100);

  /** Of those that are looked at, as they may grow fast; longer where looking takes long. */
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
   * @param onEnd what is done then, whatever the reason of its end
   */
  static void over(
      Process process, ControlGroup group, int limitMiB, Runnable onExcess, Runnable onEnd) {
    Thread thread =
        new Thread(new MemoryWatch(process, group, limitMiB, onExcess, onEnd), "sitaf-memory");
    thread.setDaemon(true);
    thread.start();
  }

  @Override
  public void run() {
    try {
      long pause = group.bindsMemory() ? PERIOD.toMillis() : SHORTEST.toMillis();
      while (!process.waitFor(pause, TimeUnit.MILLISECONDS)) {
        long before = System.nanoTime();
        if (isExceeded()) {
          onExcess.run();
          break;
        }
        long took = Duration.ofNanos(System.nanoTime() - before).toMillis();
        if (!group.bindsMemory()) {
          pause = Math.max(SHORTEST.toMillis(), PAUSE_FACTOR * took);
        }
      }
      process.waitFor();
      onEnd.run();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private boolean isExceeded() {
    return group.bindsMemory()
        ? group.exceededMemory()
        : MemoryUse.kibOf(process.pid()) > (long) limitMiB << 10;
  }
}
