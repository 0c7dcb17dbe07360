package org.sitaf.runtime;

import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.sitaf.runtime.suite.CaseResult;
import org.sitaf.runtime.suite.TestCase;
import org.sitaf.runtime.suite.TestStep;

/**
 * Base class of the generated test drivers of sequences: a case is a list of steps, each of them a
 * call of the component or an event of its world.
 *
 * @param <C> class of the component under test
 */
public abstract class SequenceDriver<C> extends SuiteDriver<C> {
  private @Nullable TestCase current;

  /** Creates the driver of a run; see {@link SuiteDriver}. */
  protected SequenceDriver(TestRun run, LifeCycle lifeCycle, String... notHooks) {
    super(run, lifeCycle, notHooks);
  }

  /** Sets up the world, the stubs and the component of a case. */
  protected abstract void beginSequence(TestCase testCase) throws Exception;

  /**
   * Executes a step: makes its call, or sets what its event sets.
   *
   * @param result receives the outputs of the call
   */
  protected abstract void runStep(TestStep step, CaseResult result) throws Exception;

  /** Lets the time after the last step pass. */
  protected abstract void endSequence(TestCase testCase) throws Exception;

  /** Whether the next step begins while this one runs. */
  protected boolean overlaps(TestStep step) {
    return false;
  }

  /** How many steps run at once at most. */
  protected int atOnce() {
    return Integer.MAX_VALUE;
  }

  @Override
  protected final void runCase(TestCase testCase, CaseResult result) throws Exception {
    current = testCase;
    beginSequence(testCase);
    boolean complete =
        testCase.steps().stream().anyMatch(this::overlaps)
            ? OverlappingSteps.run(run(), this, testCase.steps(), atOnce())
            : runInTurn(testCase);
    if (complete) {
      run().endSteps();
      endSequence(testCase);
    }
    saveSequence(result);
  }

  /** Executes each step after the one before; returns whether all were executed. */
  private boolean runInTurn(TestCase testCase) throws Exception {
    for (TestStep step : testCase.steps()) {
      if (!run().runStep(this, step, new CaseResult(step))) {
        return false;
      }
    }
    return true;
  }

  /** The case that is executed, whose initial values may be properties of the component. */
  protected final TestCase currentCase() {
    return Objects.requireNonNull(current);
  }

  /** The exception for a step that this driver does not know. */
  protected final CannotRunException unknown(TestStep step) {
    return new CannotRunException(
        "the test driver has no step '" + step.name() + "': generate the test application again");
  }
}
