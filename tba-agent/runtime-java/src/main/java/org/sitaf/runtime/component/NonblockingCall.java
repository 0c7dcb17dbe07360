package org.sitaf.runtime.component;

import java.util.Objects;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.sitaf.runtime.Stopwatch;
import org.sitaf.runtime.simulation.Simulation;

/**
 * A nonblocking call. It runs on its own thread, so that simulation time passes during the call.
 *
 * @param <T> the boxed return type
 */
public final class NonblockingCall<T> {
  private final @Nullable Simulation simulation;
  private final Thread thread;
  private volatile @Nullable T returned;
  private volatile @Nullable Throwable thrown;

  private NonblockingCall(Stopwatch stopwatch, @Nullable Simulation simulation, Callable<T> call) {
    this.simulation = simulation;
    Stopwatch own = stopwatch.ofThisThread();
    this.thread = new Thread(() -> run(stopwatch, own, call), "call under test");
    thread.setDaemon(true);
  }

  /**
   * Starts a call.
   *
   * @param simulation its time passes only while the call waits for it; null for no simulation
   */
  public static <T> NonblockingCall<T> begin(
      Stopwatch stopwatch, @Nullable Simulation simulation, Callable<T> call) {
    NonblockingCall<T> nonblocking = new NonblockingCall<>(stopwatch, simulation, call);
    if (simulation != null) {
      simulation.time().follow(nonblocking.thread);
    }
    nonblocking.thread.start();
    if (simulation != null && !simulation.time().isDriver()) {
      // The caller is a followed thread, too: one of them runs at a time.
      simulation.time().awaitTurnOf(nonblocking.thread);
    }
    return nonblocking;
  }

  private void run(Stopwatch whole, Stopwatch stopwatch, Callable<T> call) {
    if (stopwatch != whole) {
      whole.separate(stopwatch);
    }
    stopwatch.start();
    try {
      returned = call.call();
      stopwatch.stop();
    } catch (Throwable e) {
      // The stopwatch keeps running, so the run attributes the exception to the component.
      thrown = e;
    } finally {
      if (stopwatch != whole) {
        whole.rejoin();
      }
      if (simulation != null) {
        simulation.time().leave();
      }
    }
  }

  /**
   * Waits for the call and returns its value; meanwhile simulation time passes when it waits.
   *
   * @throws Exception what the component throws
   */
  public @Nullable T outcome() throws Exception {
    if (simulation != null) {
      simulation.time().passUntilLeaves(thread);
    }
    thread.join();
    Throwable problem = thrown;
    if (problem instanceof Error error) {
      throw error;
    }
    if (problem != null) {
      throw (Exception) Objects.requireNonNull(problem);
    }
    return returned;
  }

  /**
   * Ends a call whose outcome is no longer needed, so that it does not affect the next case: its
   * waits for simulation time throw an exception. Returns when the call has ended.
   */
  public void giveUp() throws InterruptedException {
    if (simulation != null) {
      simulation.time().giveUp(thread);
    }
    thread.join();
  }
}
