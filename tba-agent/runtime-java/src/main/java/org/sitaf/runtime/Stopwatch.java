package org.sitaf.runtime;

import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.jspecify.annotations.Nullable;

/**
 * Measures one call of the component with the monotonic clock, and separately the time that the
 * call spends in virtual hardware and in stubs. Only the thread that started the stopwatch is
 * measured; other threads of the component are not part of the call.
 */
public final class Stopwatch {
  private static final double NANOS_PER_MICRO = 1000.0;

  private Runnable beforeCall = () -> {};
  private volatile @Nullable Thread owner;

  /** Stopwatches of steps that overlap, by the thread of the call. */
  private final Map<Thread, Stopwatch> others = new ConcurrentHashMap<>();

  /** Whether there are others; it keeps their lookup out of every call of hardware. */
  private volatile boolean hasOthers;

  private volatile boolean called;
  private long began;
  private long total;
  private long hardware;
  private long stub;

  /** Starts a new measurement. */
  public void start() {
    beforeCall.run();
    total = 0;
    hardware = 0;
    stub = 0;
    called = true;
    owner = Thread.currentThread();
    began = System.nanoTime();
  }

  /**
   * Ends the measurement.
   *
   * @throws IllegalStateException when none is running
   */
  public void stop() {
    long now = System.nanoTime();
    if (owner == null) {
      throw new IllegalStateException("the stopwatch is stopped before it was started");
    }
    total = now - began;
    owner = null;
  }

  /**
   * From now on, the calling thread has a stopwatch of its own.
   *
   * @param own also measures a nonblocking call that this thread begins
   */
  public void separate(Stopwatch own) {
    others.put(Thread.currentThread(), own);
    hasOthers = true;
  }

  /** Ends {@link #separate} for the calling thread. */
  public void rejoin() {
    others.remove(Thread.currentThread());
    hasOthers = !others.isEmpty();
  }

  /** The stopwatch of the calling thread: this one, unless it has its own. */
  public Stopwatch ofThisThread() {
    Stopwatch other = hasOthers ? others.get(Thread.currentThread()) : null;
    return other == null ? this : other;
  }

  /** Sets what runs before each measurement, outside of the measured time. */
  void beforeCall(Runnable action) {
    beforeCall = action;
  }

  /** Clears the measurement. */
  void reset() {
    owner = null;
    called = false;
  }

  /** Whether a call is being measured. Then an exception comes from the component. */
  boolean isRunning() {
    return owner != null;
  }

  /** Whether a call was started since the last reset. */
  boolean wasStarted() {
    return called;
  }

  /** The current time, as the argument of {@link #leaveHardware} and {@link #leaveStub}. */
  public long enter() {
    return System.nanoTime();
  }

  /** Counts the time since {@link #enter} as spent in virtual hardware. */
  public void leaveHardware(long entered) {
    Stopwatch watch = ofThisThread();
    if (Thread.currentThread() == watch.owner) {
      watch.hardware += System.nanoTime() - entered;
    }
  }

  /** Counts the time since {@link #enter} as spent in a stub. */
  public void leaveStub(long entered) {
    Stopwatch watch = ofThisThread();
    if (Thread.currentThread() == watch.owner) {
      watch.stub += System.nanoTime() - entered;
    }
  }

  /** Time of the call in microseconds, without virtual hardware and stubs. */
  public double componentMicros() {
    return Math.max(0, total - hardware - stub) / NANOS_PER_MICRO;
  }

  /** Time spent in virtual hardware, in microseconds. */
  public double hardwareMicros() {
    return hardware / NANOS_PER_MICRO;
  }

  /** Time spent in stubs, in microseconds. */
  public double stubMicros() {
    return stub / NANOS_PER_MICRO;
  }
}
