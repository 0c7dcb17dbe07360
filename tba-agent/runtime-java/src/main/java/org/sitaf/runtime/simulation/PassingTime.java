package org.sitaf.runtime.simulation;

import java.time.Duration;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.BooleanSupplier;
import java.util.function.LongConsumer;
import org.jspecify.annotations.Nullable;

/**
 * Advances simulation time in pieces that end when the component has something to do: at each of
 * its periods, and when a wait of one of its threads ends. Time is counted in steps since the case
 * was prepared; only the driver's thread advances it.
 *
 * <p>Followed threads make this deterministic: time advances only while each of them waits for it,
 * and those that continue at the same step do so one after the other, in the order in which they
 * were followed, each until it waits again or leaves.
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

  /** In the order of their beginning. */
  private final Set<Thread> followed = new LinkedHashSet<>();

  private final Set<Thread> givenUp = new HashSet<>();

  /** The thread that waits until the key leaves. */
  private final Map<Thread, Thread> joining = new HashMap<>();

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
    followed.clear();
    joining.clear();
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
    followed.add(thread);
  }

  /** Stops following the calling thread, which calls this at its end. */
  public synchronized void leave() {
    Thread self = Thread.currentThread();
    givenUp.remove(self);
    if (followed.remove(self)) {
      Thread joiner = joining.remove(self);
      if (joiner != null) {
        waiting.remove(joiner);
      }
      notifyAll();
    }
  }

  /** Whether the calling thread is the one that advances time. */
  public boolean isDriver() {
    return Thread.currentThread() == driver;
  }

  /**
   * Waits until a followed thread leaves, or has left. In the driver's thread time passes
   * meanwhile.
   */
  public void passUntilLeaves(Thread thread) {
    if (Thread.currentThread() == driver) {
      passUntil(thread, () -> false);
    } else {
      join(thread);
    }
  }

  /** Lets time pass, in the driver's thread, until a followed thread has reached something. */
  public void passUntil(Thread thread, BooleanSupplier reached) {
    while (true) {
      long steps = untilNext(thread);
      if (steps == 0 || reached.getAsBoolean()) {
        return;
      }
      move(steps);
    }
  }

  /** Waits in real time until a followed thread waits for simulation time or has left. */
  public synchronized void awaitTurnOf(Thread thread) {
    while (followed.contains(thread) && !waiting.containsKey(thread)) {
      waitHere();
    }
  }

  /** Stops following a thread: its current and later waits throw an exception. */
  public synchronized void giveUp(Thread thread) {
    if (followed.remove(thread)) {
      givenUp.add(thread);
      Thread joiner = joining.remove(thread);
      if (joiner != null) {
        waiting.remove(joiner);
      }
      notifyAll();
    }
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
        continueDue();
      }
      tickIfDue();
    }
    awaitFollowed();
  }

  /** Ends the waits that are over; followed threads continue one after the other. */
  private void continueDue() {
    waiting
        .entrySet()
        .removeIf(wait -> wait.getValue() <= step && !followed.contains(wait.getKey()));
    notifyAll();
    for (Thread thread : List.copyOf(followed)) {
      Long target = waiting.get(thread);
      if (target != null && target <= step) {
        waiting.remove(thread);
        notifyAll();
        awaitFollowed();
      }
    }
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
    waiting.put(Thread.currentThread(), step + steps);
    waitUntilRemoved();
  }

  /** Waits until another thread leaves. */
  private synchronized void join(Thread other) {
    if (followed.contains(other)) {
      joining.put(other, Thread.currentThread());
      waiting.put(Thread.currentThread(), Long.MAX_VALUE);
      waitUntilRemoved();
    }
  }

  private void waitUntilRemoved() {
    Thread self = Thread.currentThread();
    notifyAll();
    while (waiting.containsKey(self) && !givenUp.contains(self) && !ended) {
      waitHere();
    }
    if (givenUp.contains(self)) {
      waiting.remove(self);
      throw new SimulationException(
          "the case has ended, and its simulation time no longer advances");
    }
  }

  /** Waits until each followed thread waits for simulation time or has left. */
  private synchronized void awaitFollowed() {
    while (!waiting.keySet().containsAll(followed)) {
      waitHere();
    }
  }

  /** Steps until the first followed thread continues; 0 when this one has left. */
  private synchronized long untilNext(Thread thread) {
    awaitFollowed();
    if (!followed.contains(thread)) {
      return 0;
    }
    long next = Long.MAX_VALUE;
    for (Thread each : followed) {
      next = Math.min(next, waiting.getOrDefault(each, Long.MAX_VALUE));
    }
    return next - step;
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
