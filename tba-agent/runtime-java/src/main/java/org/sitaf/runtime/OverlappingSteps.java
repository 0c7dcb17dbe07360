package org.sitaf.runtime;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.sitaf.runtime.simulation.CaseTooLongException;
import org.sitaf.runtime.simulation.PassingTime;
import org.sitaf.runtime.simulation.SimulationException;
import org.sitaf.runtime.suite.CaseResult;
import org.sitaf.runtime.suite.TestStep;

/**
 * Executes the steps of a case of which some overlap. An overlapping step has a thread of its own;
 * the next step begins when its call waits for simulation time or has ended, or at once without a
 * simulation. Records are written in the order of the steps.
 */
final class OverlappingSteps<C> {
  private final TestRun run;
  private final SequenceDriver<C> driver;
  private final int atOnce;

  /** The clock of the simulation; null for real time. */
  private final @Nullable PassingTime time;

  /** In the order of their beginning. */
  private final List<Begun> begun = new ArrayList<>();

  private final List<Overlapping> overlapping = new ArrayList<>();
  private int written;

  private OverlappingSteps(TestRun run, SequenceDriver<C> driver, int atOnce) {
    this.run = run;
    this.driver = driver;
    this.atOnce = atOnce;
    this.time = run.simulationIfAny() == null ? null : run.simulation().time();
  }

  /**
   * Executes steps and writes their records.
   *
   * @param atOnce how many overlapping steps run at once at most
   * @return whether all were executed: not when the case took too much simulation time
   * @throws RuntimeException when no further case can run
   */
  static <C> boolean run(TestRun run, SequenceDriver<C> driver, List<TestStep> steps, int atOnce)
      throws IOException, InterruptedException {
    return new OverlappingSteps<>(run, driver, atOnce).run(steps);
  }

  private boolean run(List<TestStep> steps) throws IOException, InterruptedException {
    String tooLong = null;
    boolean ended = false;
    try {
      for (TestStep step : steps) {
        if (driver.overlaps(step)) {
          makeRoom();
        }
        beginOf(step);
      }
      for (Overlapping step : overlapping) {
        awaitEndOf(step);
      }
      ended = true;
    } catch (CaseTooLongException e) {
      tooLong = String.valueOf(e.getMessage());
    } finally {
      if (!ended) {
        giveUp(tooLong == null ? "the case has ended" : tooLong);
      }
    }
    moveCalls();
    save();
    return ended;
  }

  /** Waits until fewer steps run than may run at once. */
  private void makeRoom() throws InterruptedException {
    int first = overlapping.size() - atOnce;
    if (first >= 0) {
      awaitEndOf(overlapping.get(first));
    }
  }

  private void beginOf(TestStep step) throws IOException, InterruptedException {
    moveCalls();
    save();
    Begun next = new Begun(step);
    begun.add(next);
    run.stepBegins(next.result);
    if (driver.overlaps(step)) {
      Overlapping thread = new Overlapping(next);
      overlapping.add(thread);
      thread.begin();
    } else {
      CaseTooLongException tooLong = run.executeStep(driver, step, next.result);
      next.ended = true;
      if (tooLong != null) {
        throw tooLong;
      }
    }
  }

  private void awaitEndOf(Overlapping step) throws InterruptedException {
    if (time != null) {
      pass(step, () -> time.passUntilLeaves(step.thread));
    }
    step.thread.join();
    step.rethrow();
  }

  /** Lets time pass for a step; an exception of a periodic component meanwhile ends the step. */
  private void pass(Overlapping step, Runnable passing) throws InterruptedException {
    try {
      passing.run();
    } catch (CaseTooLongException e) {
      throw e;
    } catch (Throwable thrown) {
      if (thrown instanceof SimulationException refused && refused.isLost()) {
        throw refused;
      }
      step.stop(ThrownByComponent.describe(thrown));
    }
  }

  /** Ends the steps that still run, one after the other. */
  private void giveUp(String reason) throws InterruptedException {
    for (Overlapping step : overlapping) {
      step.stop(reason);
    }
  }

  /** The calls of stubs so far belong to the step that began last. */
  private void moveCalls() {
    if (!begun.isEmpty()) {
      run.moveCallsTo(begun.get(begun.size() - 1).result);
    }
  }

  /** Writes the records of steps that have ended, up to the first one that has not. */
  private void save() throws IOException {
    while (written < begun.size() && begun.get(written).ended) {
      run.saveStep(begun.get(written).result);
      written++;
    }
  }

  /** A step that has begun. */
  private static final class Begun {
    private final TestStep step;
    private final CaseResult result;
    private volatile boolean ended;

    Begun(TestStep step) {
      this.step = step;
      this.result = new CaseResult(step);
    }
  }

  /** A step on its own thread. */
  private final class Overlapping {
    private final Begun step;
    private final Thread thread;
    private final Stopwatch stopwatch = new Stopwatch();
    private volatile @Nullable String stopped;
    private volatile @Nullable Throwable fatal;

    Overlapping(Begun step) {
      this.step = step;
      this.thread =
          new Thread(this::execute, "step " + step.step.number() + " (" + step.step.name() + ")");
      thread.setDaemon(true);
    }

    void begin() throws InterruptedException {
      if (time == null) {
        thread.start();
        return;
      }
      time.follow(thread);
      thread.start();
      // What settles before the call passes before the next step begins.
      pass(this, () -> time.passUntil(thread, stopwatch::wasStarted));
    }

    /** Ends the step if it still runs, as an error: its waits throw an exception. */
    void stop(String reason) throws InterruptedException {
      if (!step.ended) {
        stopped = reason;
        if (time != null) {
          time.giveUp(thread);
        }
      }
      thread.join();
    }

    private void execute() {
      run.stopwatch().separate(stopwatch);
      try {
        CaseTooLongException unused = run.executeStep(driver, step.step, step.result);
      } catch (Throwable e) {
        fatal = e;
      } finally {
        String reason = stopped;
        if (reason != null) {
          step.result.stopped(reason);
        }
        run.stopwatch().rejoin();
        step.ended = true;
        if (time != null) {
          time.leave();
        }
      }
    }

    /** Throws what ended the run, not only this step. */
    void rethrow() {
      Throwable problem = fatal;
      if (problem instanceof RuntimeException unchecked) {
        throw unchecked;
      }
      if (problem instanceof Error error) {
        throw error;
      }
      if (problem != null) {
        throw new IllegalStateException(problem);
      }
    }
  }
}
