package org.sitaf.core.suite.sequence;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.expression.Variables;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.sequence.SequenceCall;
import org.sitaf.core.suite.TestStep;
import org.sitaf.core.value.TestValue;

/** The abstract state before each step of a case, as the model defines it. */
public final class StepStates {
  private final StateVariables states;
  private final List<CompiledStep> steps;

  private StepStates(StateVariables states, List<CompiledStep> steps) {
    this.states = states;
    this.steps = steps;
  }

  /**
   * Compiles the steps of a model with a sequence.
   *
   * @throws org.sitaf.core.diagnostic.InvalidInputException if an expression is invalid
   */
  public static StepStates of(TestModel model) {
    Diagnostics diagnostics = new Diagnostics();
    SequenceCompiler compiler = new SequenceCompiler(model, diagnostics);
    List<CompiledStep> steps = compiler.compile();
    diagnostics.throwIfErrors();
    return new StepStates(compiler.states(), steps);
  }

  /** The state before the first step. */
  public AbstractState initial() {
    return states.initial();
  }

  /** The variables of expressions in a state, by name. */
  public Map<String, Object> variables(AbstractState state) {
    return states.variables(state).map();
  }

  /** Adds the variables of a state. */
  public void put(Variables variables, AbstractState state) {
    states.put(variables, state);
  }

  /** Whether the guard of a step is true. */
  public boolean isAllowed(AbstractState state, String step) {
    return step(step).isAllowed(state);
  }

  /**
   * The state after a step.
   *
   * @param failed whether the call ended with an error, which leaves the state; a step whose guard
   *     is false leaves it, too
   * @throws IllegalArgumentException if an update cannot be evaluated
   */
  public AbstractState after(AbstractState before, TestStep step, boolean failed) {
    CompiledStep compiled = step(step.name());
    if (failed || !compiled.isAllowed(before)) {
      return before;
    }
    try {
      return compiled.after(before, row(compiled, step));
    } catch (StepException e) {
      throw new IllegalArgumentException(e.where() + " " + e.getMessage(), e);
    }
  }

  /**
   * The state before each step.
   *
   * @param failed for each step, whether it ended with an error
   */
  public List<AbstractState> before(List<TestStep> of, List<Boolean> failed) {
    List<AbstractState> before = new ArrayList<>();
    AbstractState state = initial();
    for (int i = 0; i < of.size(); i++) {
      before.add(state);
      state = after(state, of.get(i), failed.get(i));
    }
    return before;
  }

  private CompiledStep step(String name) {
    return steps.stream()
        .filter(s -> s.step().name().equals(name))
        .findFirst()
        .orElseThrow(() -> new IllegalArgumentException("the model has no step " + name));
  }

  private static StepRow row(CompiledStep compiled, TestStep step) {
    SequenceCall call = compiled.call().orElse(null);
    List<TestValue> values = new ArrayList<>();
    for (int i = 0; call != null && i < step.values().size(); i++) {
      values.add(
          new TestValue(
              Objects.requireNonNull(call.model().inputs().get(i)).value(step.values().get(i)),
              step.valid()));
    }
    return new StepRow(values);
  }
}
