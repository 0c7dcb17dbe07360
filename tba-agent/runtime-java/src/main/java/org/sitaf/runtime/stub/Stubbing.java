package org.sitaf.runtime.stub;

import java.time.Duration;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.sitaf.runtime.Stopwatch;
import org.sitaf.runtime.simulation.Simulation;
import org.sitaf.runtime.suite.CaseResult;

/** State that the stubbed methods of a run share: stopwatch, recorded calls, and simulation. */
public final class Stubbing {
  private final Stopwatch stopwatch;
  private final @Nullable Simulation simulation;
  private final StubCalls calls = new StubCalls();

  /**
   * Creates the state of one run.
   *
   * @param simulation delays answers in simulation time; null for real time
   */
  public Stubbing(Stopwatch stopwatch, @Nullable Simulation simulation) {
    this.stopwatch = Objects.requireNonNull(stopwatch);
    this.simulation = simulation;
  }

  /** Starts a case: clears the recorded calls. */
  public void begin() {
    calls.clear();
  }

  /** Adds the recorded calls to the result of the case. */
  public void writeTo(CaseResult result) {
    calls.writeTo(result);
  }

  /** Moves the calls so far to the result of a step; later ones belong to another step. */
  public void moveTo(CaseResult result) {
    calls.moveTo(result);
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
