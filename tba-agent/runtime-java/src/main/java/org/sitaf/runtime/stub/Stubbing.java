package org.sitaf.runtime.stub;

import java.time.Duration;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.sitaf.runtime.Stopwatch;
import org.sitaf.runtime.simulation.Simulation;
import org.sitaf.runtime.suite.CaseResult;

/** What the stubbed methods of a run share: the clock, the record of calls, and how time passes. */
public final class Stubbing {
  private final Stopwatch stopwatch;
  private final @Nullable Simulation simulation;
  private final StubCalls calls = new StubCalls();

  /**
   * Creates the state of one run.
   *
   * @param simulation whose time a delayed answer takes; null where real time passes
   */
  public Stubbing(Stopwatch stopwatch, @Nullable Simulation simulation) {
    this.stopwatch = Objects.requireNonNull(stopwatch);
    this.simulation = simulation;
  }

  /** Begins a case: clears the recorded calls. */
  public void begin() {
    calls.forget();
  }

  /** Adds the record of the case to its result. */
  public void writeTo(CaseResult result) {
    calls.writeTo(result);
  }

  Stopwatch stopwatch() {
    return stopwatch;
  }

  StubCalls calls() {
    return calls;
  }

  /** Waits for a delayed answer. */
  void pass(Duration delay) throws InterruptedException {
    if (simulation == null) {
      Thread.sleep(delay.toMillis(), delay.getNano() % 1_000_000);
    } else {
      simulation.advance(delay);
    }
  }
}
