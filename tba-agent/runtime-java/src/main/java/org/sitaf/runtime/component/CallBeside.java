package org.sitaf.runtime.component;

import java.util.Objects;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.sitaf.runtime.Stopwatch;
import org.sitaf.runtime.simulation.Simulation;

/**
 * A nonblocking call: runs on its own thread, so that time passes during the call.
 *
 * @param <T> the boxed return type
 */
public final class CallBeside<T> {
  private final @Nullable Simulation simulation;
  private final Thread thread;
  private volatile @Nullable T returned;
  private volatile @Nullable Throwable thrown;

  private CallBeside(Stopwatch stopwatch, @Nullable Simulation simulation, Callable<T> call) {
    this.simulation = simulation;
    this.thread = new Thread(() -> make(stopwatch, call), "call under test");
    thread.setDaemon(true);
  }

  /**
   * Begins a call.
   *
   * @param simulation whose time passes only while the call waits for it; null for none
   */
  public static <T> CallBeside<T> begin(
      Stopwatch stopwatch, @Nullable Simulation simulation, Callable<T> call) {
    CallBeside<T> beside = new CallBeside<>(stopwatch, simulation, call);
    if (simulation != null) {
      simulation.time().follow(beside.thread);
    }
    beside.thread.start();
    return beside;
  }

  private void make(Stopwatch stopwatch, Callable<T> call) {
    stopwatch.start();
    try {
      returned = call.call();
      stopwatch.stop();
    } catch (Throwable e) {
      // The watch goes on: that is how the run knows who threw it.
      thrown = e;
    } finally {
      if (simulation != null) {
        simulation.time().leave();
      }
    }
  }

  /**
   * What the call returns; until then the simulation time that it waits for passes.
   *
   * @throws Exception what the component throws
   */
  public @Nullable T outcome() throws Exception {
    if (simulation != null) {
      simulation.time().passUntilItLeaves();
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
   * Waits for the end of a call whose outcome is not asked for any more, so that it does nothing to
   * the next case; it gets an exception wherever it waits for simulation time.
   */
  public void giveUp() throws InterruptedException {
    if (simulation != null) {
      simulation.time().giveUp();
    }
    thread.join();
  }
}
