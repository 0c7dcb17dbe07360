package org.sitaf.runtime.simulation;

import java.time.Duration;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.LongConsumer;
import org.jspecify.annotations.Nullable;

/**
 * Advances simulation time in pieces that end when the component has something to do: at each of
 * its periods, and when a wait of one of its threads ends. Time is counted in steps since the case
 * was prepared; only the driver's thread advances it.
 */
public final class PassingTime {
  private final long timestepNanos;
  private final LongConsumer simulator;

  /** The step at which each waiting thread continues. */
  private final Map<Thread, Long> waiting = new ConcurrentHashMap<>();

  private volatile Thread driver = Thread.currentThread();
  private long step;
  private long settledSteps;
  private long maxSteps = Long.MAX_VALUE;
  private Duration limit = Duration.ZERO;
  private @Nullable Periods periods;
  private @Nullable Thread followed;
  private @Nullable Thread givenUp;
  private boolean ended;

  /**
   * Creates a clock at 0.
   *
   * @param simulator advances the world by a number of steps
   */
  PassingTime(long timestepNanos, LongConsumer simulator) {
    this.timestepNanos = timestepNanos;
    this.simulator = simulator;
  }

  /** Ticks that fall on the first step at or after each whole period since {@code begin}. */
  private static final class Periods {
    private final long nanos;
    private final Tick tick;
    private final long begin;
    private long count = 1;
    private boolean running;

    Periods(long nanos, Tick tick, long begin) {
      this.nanos = nanos;
      this.tick = tick;
      this.begin = begin;
    }
  }

  long stepsIn(Duration time) {
    long nanos = time.toNanos();
    return nanos <= 0 ? 0 : (nanos - 1) / timestepNanos + 1;
  }

  /**
   * Starts a new case with the calling thread as its driver; waits of the previous case end.
   *
   * @param settled time of the case that has already passed
   */
  synchronized void restart(Duration settled) {
    settledSteps = stepsIn(settled);
    driver = Thread.currentThread();
    periods = null;
    followed = null;
    waiting.clear();
    step = 0;
    notifyAll();
  }

  synchronized void every(Duration period, Tick tick) {
    if (period.isZero() || period.isNegative()) {
      throw new IllegalArgumentException("the period " + period + " must be above zero");
    }
    periods = new Periods(period.toNanos(), tick, step);
  }

  /**
   * Lets time pass only while a thread waits for it, until the thread {@link #leave leaves} or the
   * next case is prepared. Everything that the thread does then happens at the same simulation time
   * in every run. Call this before the thread is started.
   */
  public synchronized void follow(Thread thread) {
    followed = thread;
    givenUp = null;
  }

  /** Stops following the calling thread, which calls this at its end. */
  public synchronized void leave() {
    if (followed == Thread.currentThread()) {
      followed = null;
      notifyAll();
    }
  }

  /** Lets time pass until the followed thread leaves; does nothing when no thread is followed. */
  public void passUntilThreadLeaves() {
    for (long steps = awaited(); steps > 0; steps = awaited()) {
      move(steps);
    }
  }

  /** Stops following the thread: its current and later waits throw an exception. */
  public synchronized void giveUp() {
    givenUp = followed;
    followed = null;
    notifyAll();
  }

  synchronized void end() {
    ended = true;
    notifyAll();
  }

  /** Advances time in the driver's thread; other threads wait until the driver has advanced it. */
  void pass(Duration time) {
    long steps = stepsIn(time);
    if (steps == 0) {
      return;
    }
    if (Thread.currentThread() == driver) {
      move(steps);
    } else {
      await(steps);
    }
  }

  /** Limits the simulation time of each case. */
  synchronized void limit(Duration time) {
    maxSteps = stepsIn(time);
    limit = time;
  }

  private void move(long steps) {
    long end = step + steps;
    if (settledSteps + end > maxSteps) {
      throw new CaseTooLongException(limit);
    }
    while (step < end) {
      awaitFollowed();
      long stop = Math.min(end, nextTick());
      for (long target : waiting.values()) {
        stop = target > step ? Math.min(stop, target) : stop;
      }
      simulator.accept(stop - step);
      synchronized (this) {
        step = stop;
        waiting.values().removeIf(target -> target <= step);
        notifyAll();
      }
      tickIfDue();
    }
    awaitFollowed();
  }

  private long nextTick() {
    Periods ticking = periods;
    if (ticking == null || ticking.running) {
      return Long.MAX_VALUE;
    }
    // Ticks during a sleep of the component itself are skipped.
    while (at(ticking) <= step) {
      ticking.count++;
    }
    return at(ticking);
  }

  private void tickIfDue() {
    Periods ticking = periods;
    if (ticking == null || ticking.running || at(ticking) != step) {
      return;
    }
    ticking.count++;
    ticking.running = true;
    try {
      ticking.tick.tick();
    } catch (Exception e) {
      throw PassingTime.<RuntimeException>unwrapped(e);
    } finally {
      ticking.running = false;
    }
  }

  private long at(Periods ticking) {
    return ticking.begin + (ticking.count * ticking.nanos - 1) / timestepNanos + 1;
  }

  /** Throws a checked exception without a wrapper, so that the record names the original type. */
  @SuppressWarnings({"unchecked", "TypeParameterUnusedInFormals"})
  private static <E extends Exception> E unwrapped(Exception e) throws E {
    throw (E) e;
  }

  private synchronized void await(long steps) {
    Thread self = Thread.currentThread();
    waiting.put(self, step + steps);
    notifyAll();
    while (waiting.containsKey(self) && self != givenUp && !ended) {
      waitHere();
    }
    if (self == givenUp) {
      waiting.remove(self);
      throw new SimulationException(
          "the case has ended, and its simulation time no longer advances");
    }
  }

  /** Waits until the followed thread waits for simulation time or has left. */
  private synchronized void awaitFollowed() {
    while (followed != null && !waiting.containsKey(followed)) {
      waitHere();
    }
  }

  /** Steps that the followed thread waits for; 0 when it has left. */
  private synchronized long awaited() {
    awaitFollowed();
    Thread thread = followed;
    return thread == null ? 0 : Objects.requireNonNull(waiting.get(thread)) - step;
  }

  private void waitHere() {
    try {
      wait();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IllegalStateException("interrupted while waiting for simulation time", e);
    }
  }
}
