package org.sitaf.runtime.simulation;

import java.time.Duration;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.LongConsumer;
import org.jspecify.annotations.Nullable;

/**
 * Lets simulation time pass in pieces that end where a component has something to do: at each of
 * its periods, and when a wait of one of its threads is over. Time is counted in steps since the
 * case was prepared, and moves in the driver's thread only.
 */
final class PassingTime {
  private final long timestepNanos;
  private final LongConsumer simulator;

  /** The steps at which waiting threads go on. */
  private final Map<Thread, Long> waiting = new ConcurrentHashMap<>();

  private volatile Thread driver = Thread.currentThread();
  private long step;
  private long mostSteps = Long.MAX_VALUE;
  private Duration limit = Duration.ZERO;
  private @Nullable Periods periods;
  private @Nullable Thread followed;
  private boolean ended;

  /**
   * A clock at 0.
   *
   * @param simulator moves the world by that many steps
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
    private boolean atWork;

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
   * A new case begins, whose driver is the calling thread; what waited for the last one goes on.
   */
  synchronized void restart() {
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

  synchronized void follow(Thread thread) {
    followed = thread;
  }

  synchronized void end() {
    ended = true;
    notifyAll();
  }

  /** Moves time in the driver's thread; in any other, waits for the driver to have moved it. */
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

  /** Bounds the time of each case. */
  synchronized void limit(Duration time) {
    mostSteps = stepsIn(time);
    limit = time;
  }

  private void move(long steps) {
    long end = step + steps;
    if (end > mostSteps) {
      throw new SimulationException(
          "the case took more than " + limit.toMillis() / 1e3 + " s of simulation time");
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
    if (ticking == null || ticking.atWork) {
      return Long.MAX_VALUE;
    }
    // A component that let time pass itself skips the ticks that it slept through.
    while (at(ticking) <= step) {
      ticking.count++;
    }
    return at(ticking);
  }

  private void tickIfDue() {
    Periods ticking = periods;
    if (ticking == null || ticking.atWork || at(ticking) != step) {
      return;
    }
    ticking.count++;
    ticking.atWork = true;
    try {
      ticking.tick.tick();
    } catch (Exception e) {
      throw PassingTime.<RuntimeException>asItIs(e);
    } finally {
      ticking.atWork = false;
    }
  }

  private long at(Periods ticking) {
    return ticking.begin + (ticking.count * ticking.nanos - 1) / timestepNanos + 1;
  }

  /** Drivers declare every exception; a wrapper would hide what the component threw. */
  @SuppressWarnings({"unchecked", "TypeParameterUnusedInFormals"})
  private static <E extends Exception> E asItIs(Exception e) throws E {
    throw (E) e;
  }

  private synchronized void await(long steps) {
    Thread self = Thread.currentThread();
    waiting.put(self, step + steps);
    notifyAll();
    while (waiting.containsKey(self) && !ended) {
      waitHere();
    }
  }

  /** Until the thread that is followed waits for simulation time, or is at its end. */
  private synchronized void awaitFollowed() {
    while (followed != null && followed.isAlive() && !waiting.containsKey(followed)) {
      waitHere();
    }
  }

  private void waitHere() {
    try {
      // The end of a thread notifies nobody here.
      wait(1);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IllegalStateException("interrupted while waiting for simulation time", e);
    }
  }
}
