package org.sitaf.core.suite.sequence;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.expression.EvaluationException;
import org.sitaf.core.expression.Expression;
import org.sitaf.core.expression.Variables;
import org.sitaf.core.model.OutputElement;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.Value;
import org.sitaf.core.model.sequence.SequenceCall;
import org.sitaf.core.model.sequence.SequenceSpec;
import org.sitaf.core.model.sequence.SequenceStep;
import org.sitaf.core.model.sequence.StateUpdate;
import org.sitaf.core.suite.CaseVariables;
import org.sitaf.core.suite.ExpectedValue;
import org.sitaf.core.suite.ResultLiteral;

/** The compiled expressions of a kind of step. */
final class CompiledStep {
  private final StateVariables states;
  private final SequenceStep step;
  private final @Nullable Expression guard;
  private final List<Update> updates;
  private final Map<String, Expression> expected;
  private final @Nullable Expression forbidden;

  /** A compiled update of the variable with this index. */
  record Update(int state, Expression expression, StateUpdate source) {}

  CompiledStep(
      StateVariables states,
      SequenceStep step,
      @Nullable Expression guard,
      List<Update> updates,
      Map<String, Expression> expected,
      @Nullable Expression forbidden) {
    this.states = states;
    this.step = step;
    this.guard = guard;
    this.updates = List.copyOf(updates);
    this.expected = Map.copyOf(expected);
    this.forbidden = forbidden;
  }

  SequenceStep step() {
    return step;
  }

  /** The call; empty for an event. */
  Optional<SequenceCall> call() {
    return step instanceof SequenceCall call ? Optional.of(call) : Optional.empty();
  }

  boolean hasForbidden() {
    return forbidden != null;
  }

  /** Whether the guard is true. */
  boolean isAllowed(AbstractState state) {
    if (guard == null) {
      return true;
    }
    try {
      return guard.isTrue(states.variables(state).map());
    } catch (EvaluationException e) {
      throw problem(
          java.util.Objects.requireNonNull(step.guard()).line(), "guard", state, e.getMessage());
    }
  }

  /**
   * The state after the step.
   *
   * @param row values of the call
   * @throws StepException if an update cannot be evaluated or gives a value of another type
   */
  AbstractState after(AbstractState state, StepRow row) {
    if (updates.isEmpty()) {
      return state;
    }
    Variables variables = states.variables(state);
    call().ifPresent(c -> putInputs(variables, c.model(), row));
    List<String> literals = new ArrayList<>(state.literals());
    for (Update update : updates) {
      try {
        literals.set(
            update.state(),
            states.literal(update.state(), update.expression().evaluate(variables.map())));
      } catch (EvaluationException | IllegalArgumentException e) {
        throw problem(
            update.source().line(),
            "update " + update.source().state(),
            state,
            row.values().isEmpty() ? e.getMessage() : row.literals() + ": " + e.getMessage());
      }
    }
    return new AbstractState(literals);
  }

  /** The expected values of a call, in the order of its outputs. */
  List<ExpectedValue> expected(AbstractState state, int number, StepRow row) {
    SequenceCall call = call().orElse(null);
    if (call == null || expected.isEmpty()) {
      return List.of();
    }
    TestModel model = call.model();
    Variables variables = beforeCall(model, state, number, row);
    List<ExpectedValue> values = new ArrayList<>();
    for (OutputElement output : model.outputs()) {
      Expression expression = expected.get(output.name());
      if (expression != null) {
        String name = model.outputs().size() == 1 ? "" : output.name();
        values.add(new ExpectedValue(name, literal(expression, variables, output)));
      }
    }
    return values;
  }

  private static String literal(Expression expression, Variables variables, OutputElement output) {
    try {
      return ResultLiteral.of(expression.evaluate(variables.map()), output.type());
    } catch (EvaluationException | IllegalArgumentException e) {
      return ExpectedValue.UNEVALUATED + " " + e.getMessage();
    }
  }

  /** The outcome of a call whose guard is false. */
  List<ExpectedValue> forbidden(AbstractState state, int number, StepRow row) {
    TestModel model = call().orElseThrow().model();
    Expression outcome = java.util.Objects.requireNonNull(forbidden);
    Optional<OutputElement> returned = model.output(OutputElement.RETURN_NAME);
    Variables variables = beforeCall(model, state, number, row);
    String literal;
    try {
      Object result = outcome.evaluate(variables.map());
      literal =
          returned.isPresent()
              ? ResultLiteral.of(result, returned.get().type())
              : String.valueOf(result);
    } catch (EvaluationException | IllegalArgumentException e) {
      literal = ExpectedValue.UNEVALUATED + " " + e.getMessage();
    }
    return List.of(
        new ExpectedValue(
            model.outputs().size() > 1 && returned.isPresent() ? OutputElement.RETURN_NAME : "",
            literal));
  }

  /** Whether an expected value of a call is an error, which leaves the state. */
  static boolean isError(List<ExpectedValue> expected) {
    return expected.stream()
        .anyMatch(
            e -> e.literal().startsWith(Value.ERROR_PREFIX) || e.literal().equals(Value.ANY_ERROR));
  }

  /** The inputs on which the state afterwards depends. */
  Set<String> relevantInputs() {
    Set<String> relevant = new HashSet<>();
    SequenceCall call = call().orElse(null);
    if (call == null) {
      return relevant;
    }
    List<Expression> used = new ArrayList<>(updates.stream().map(Update::expression).toList());
    if (!updates.isEmpty()) {
      used.addAll(errorOutcomes());
    }
    call.model()
        .inputs()
        .forEach(
            input -> {
              Set<String> names =
                  Variables.roots(List.of(input.name(), Variables.VALID_PREFIX + input.name()));
              if (used.stream().anyMatch(e -> names.stream().anyMatch(e::mentions))) {
                relevant.add(input.name());
              }
            });
    return relevant;
  }

  /** Whether the state afterwards depends on the number of the step. */
  boolean dependsOnNumber() {
    return !updates.isEmpty()
        && errorOutcomes().stream().anyMatch(e -> e.mentions(SequenceSpec.STEP));
  }

  /** The expected values that may be errors. */
  private List<Expression> errorOutcomes() {
    SequenceCall call = call().orElse(null);
    return call == null
        ? List.of()
        : call.model().outputs().stream()
            .filter(o -> o.expected() != null && mayBeError(call.model(), o.expected()))
            .map(o -> expected.get(o.name()))
            .filter(java.util.Objects::nonNull)
            .toList();
  }

  private static boolean mayBeError(TestModel model, String expected) {
    return expected.contains(Value.ANY_ERROR)
        || model.definitions().stream().anyMatch(d -> d.expression().contains(Value.ANY_ERROR));
  }

  private Variables beforeCall(TestModel model, AbstractState state, int number, StepRow row) {
    Variables variables = CaseVariables.of(model, row.values());
    states.put(variables, state);
    variables.put(SequenceSpec.STEP, (long) number);
    return variables;
  }

  private static void putInputs(Variables variables, TestModel model, StepRow row) {
    variables.map().putAll(CaseVariables.of(model, row.values()).map());
  }

  private StepException problem(int line, String part, AbstractState state, @Nullable String why) {
    return new StepException(
        line,
        step.name() + "/" + part,
        "cannot be evaluated in the state (" + states.text(state) + "): " + why);
  }
}
