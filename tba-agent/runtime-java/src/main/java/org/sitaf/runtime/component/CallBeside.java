package org.sitaf.runtime.component;

import java.time.Duration;
import java.util.Objects;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.sitaf.runtime.Stopwatch;
import org.sitaf.runtime.simulation.Simulation;

/**
 * A nonblocking call: made on a thread of its own, so that time passes meanwhile.
 *
 * @param <T> the boxed return type
 */
public final class CallBeside<T> {
  /** How much simulation time passes at once while the call goes on after all else is done. */
  private static final Duration STRETCH = Duration.ofMillis(10);

  private final @Nullable Simulation simulation;
  private final Thread thread;
  private volatile @Nullable T returned;
  private volatile @Nullable Throwable thrown;

  private CallBeside(Stopwatch stopwatch, @Nullable Simulation simulation, Callable<T> call) {
    this.simulation = simulation;
    this.thread =
        new Thread(
            () -> {
              stopwatch.start();
              try {
                returned = call.call();
                stopwatch.stop();
              } catch (Throwable e) {
                // The watch goes on: that is how the run knows who threw it.
                thrown = e;
              }
            },
            "call under test");
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
    beside.thread.start();
    if (simulation != null) {
      simulation.follow(beside.thread);
    }
    return beside;
  }

  /**
   * What the call returns, as soon as it does; simulation time passes until then.
   *
   * @throws Exception what the component throws
   */
  public @Nullable T outcome() throws Exception {
    while (simulation != null && thread.isAlive()) {
      simulation.advance(STRETCH);
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
}
