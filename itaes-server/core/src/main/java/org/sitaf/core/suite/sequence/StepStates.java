package org.sitaf.core.suite.sequence;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.ExpectedValue;
import org.sitaf.core.suite.InputValidity;
import org.sitaf.core.suite.TestStep;

/** The abstract states of a case while its steps are executed. */
public final class StepStates {
  private final StateVariables variables;
  private final Map<String, CompiledStep> steps = new HashMap<>();
  private final Map<String, InputValidity> validities = new HashMap<>();

  /**
   * Compiles the guards and updates of a model, which were verified when it was read.
   *
   * @param model has a sequence
   * @param seed seed of the suite
   */
  public StepStates(TestModel model, long seed) {
    SequenceCompiler compiler = new SequenceCompiler(model, new Diagnostics());
    for (CompiledStep step : compiler.compile()) {
      steps.put(step.step().name(), step);
      step.call()
          .ifPresent(call -> validities.put(call.name(), new InputValidity(call.model(), seed)));
    }
    variables = compiler.states();
  }

  /** The state before the first step. */
  public AbstractState initial() {
    return variables.initial();
  }

  /** The values of a state for expressions, by name. */
  public Map<String, Object> variables(AbstractState state) {
    return variables.variables(state).map();
  }

  /**
   * The state after a step that behaves as its expected value says: an expected error leaves the
   * state.
   *
   * @return empty if the step is not allowed or the state cannot be computed
   */
  public Optional<AbstractState> planned(AbstractState before, TestStep step) {
    CompiledStep compiled = steps.get(step.name());
    try {
      return compiled == null || !compiled.isAllowed(before)
          ? Optional.empty()
          : leaves(compiled, before, step) ? Optional.of(before) : after(before, step);
    } catch (StepException e) {
      return Optional.empty();
    }
  }

  /** Whether the guard of a call is false and the model says what the call does then. */
  public boolean isForbidden(AbstractState state, TestStep step) {
    CompiledStep compiled = steps.get(step.name());
    return compiled != null && compiled.hasForbidden() && !isAllowed(state, step);
  }

  /**
   * Another sequence of steps with the expected values that they have there.
   *
   * @return empty if a step may not be executed where it is, more than one step is forbidden or
   *     invalid, or an expected value cannot be evaluated
   */
  public Optional<List<TestStep>> replanned(List<TestStep> given) {
    List<TestStep> written = new ArrayList<>();
    AbstractState state = initial();
    boolean failed = false;
    for (TestStep step : given) {
      CompiledStep compiled = steps.get(step.name());
      if (compiled == null) {
        return Optional.empty();
      }
      try {
        boolean allowed = compiled.isAllowed(state);
        StepRow row = row(compiled, step);
        boolean valid = allowed && row.isValid();
        if (!allowed && !compiled.hasForbidden() || !valid && failed) {
          return Optional.empty();
        }
        failed |= !valid;
        int number = written.size() + 1;
        List<ExpectedValue> expected =
            allowed
                ? compiled.expected(state, number, row)
                : compiled.forbidden(state, number, row);
        if (expected.stream().anyMatch(e -> e.literal().startsWith(ExpectedValue.UNEVALUATED))) {
          return Optional.empty();
        }
        written.add(new TestStep(step.name(), valid, step.values(), expected));
        if (allowed && !CompiledStep.isError(expected)) {
          state = compiled.after(state, row);
        }
      } catch (StepException | IllegalArgumentException e) {
        return Optional.empty();
      }
    }
    return Optional.of(written);
  }

  private boolean leaves(CompiledStep compiled, AbstractState before, TestStep step) {
    return compiled.call().isPresent()
        && CompiledStep.isError(compiled.expected(before, 1, row(compiled, step)));
  }

  private StepRow row(CompiledStep compiled, TestStep step) {
    InputValidity validity = validities.get(step.name());
    return compiled.call().isEmpty() || validity == null
        ? StepRow.NONE
        : StepRow.of(compiled.call().get().model(), step.values(), step.valid(), validity);
  }

  /** A state as results show it: {@code enabled=true, near=false}. */
  public String text(AbstractState state) {
    return variables.text(state);
  }

  /** Whether the guard of a step is true; also if it cannot be evaluated. */
  public boolean isAllowed(AbstractState state, TestStep step) {
    CompiledStep compiled = steps.get(step.name());
    try {
      return compiled == null || compiled.isAllowed(state);
    } catch (StepException e) {
      return true;
    }
  }

  /**
   * The state after a step that ended without an error. A step that its guard forbids changes
   * nothing.
   *
   * @return empty if the state cannot be computed, so that it is unknown from now on
   */
  public Optional<AbstractState> after(AbstractState before, TestStep step) {
    CompiledStep compiled = steps.get(step.name());
    if (compiled == null) {
      return Optional.of(before);
    }
    try {
      if (!compiled.isAllowed(before)) {
        return Optional.of(before);
      }
      return Optional.of(compiled.after(before, row(compiled, step)));
    } catch (StepException | IllegalArgumentException e) {
      return Optional.empty();
    }
  }
}
