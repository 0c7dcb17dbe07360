package org.sitaf.runtime.simulation;

import java.time.Duration;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.LongConsumer;
import org.jspecify.annotations.Nullable;

/**
 * Lets simulation time pass in pieces that end where a component has something to do: at each of
 * its periods, and when a wait of one of its threads is over. Time is counted in steps since the
 * case was prepared, and moves in the driver's thread only.
 */
public final class PassingTime {
  private final long timestepNanos;
  private final LongConsumer simulator;

  /** The steps at which waiting threads go on. */
  private final Map<Thread, Long> waiting = new ConcurrentHashMap<>();

  private volatile Thread driver = Thread.currentThread();
  private long step;
  private long settledSteps;
  private long mostSteps = Long.MAX_VALUE;
  private Duration limit = Duration.ZERO;
  private @Nullable Periods periods;
  private @Nullable Thread followed;
  private @Nullable Thread givenUp;
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
   *
   * @param settled time of the case that has passed already
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
   * Lets time pass only while a thread that is not started yet waits for it, until it {@link #leave
   * leaves} or the next case is prepared: what the thread does then happens at the same simulation
   * time in every run.
   */
  public synchronized void follow(Thread thread) {
    followed = thread;
    givenUp = null;
  }

  /** The calling thread is at its end, and is not followed any longer. */
  public synchronized void leave() {
    if (followed == Thread.currentThread()) {
      followed = null;
      notifyAll();
    }
  }

  /** Lets pass what the thread that is followed still waits for; nothing where none is. */
  public void passUntilItLeaves() {
    for (long steps = awaited(); steps > 0; steps = awaited()) {
      move(steps);
    }
  }

  /** No wait of the thread that is followed comes to its end any more: each is an exception. */
  public synchronized void giveUp() {
    givenUp = followed;
    followed = null;
    notifyAll();
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
    if (settledSteps + end > mostSteps) {
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
    while (waiting.containsKey(self) && self != givenUp && !ended) {
      waitHere();
    }
    if (self == givenUp) {
      waiting.remove(self);
      throw new SimulationException("the case is over, and no more of its time passes");
    }
  }

  /** Until the thread that is followed waits for simulation time, or is at its end. */
  private synchronized void awaitFollowed() {
    while (followed != null && !waiting.containsKey(followed)) {
      waitHere();
    }
  }

  /** Steps that the thread that is followed waits for; 0 when it is at its end. */
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
