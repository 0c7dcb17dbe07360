package org.sitaf.core.verdict;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.expression.EvaluationException;
import org.sitaf.core.expression.Expression;
import org.sitaf.core.expression.ExpressionCompiler;
import org.sitaf.core.expression.Variables;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.sequence.SequenceCall;
import org.sitaf.core.model.sequence.SequenceSpec;
import org.sitaf.core.model.sequence.SequenceStep;
import org.sitaf.core.model.sequence.StateUpdate;
import org.sitaf.core.model.sequence.StateVariable;
import org.sitaf.core.suite.CaseScope;

/** The abstract state of a sequence, as its steps change it. */
final class AbstractStates {
  private final Map<String, Object> initial;
  private final Map<String, Changes> steps = new HashMap<>();

  private record Update(String state, Expression expression) {}

  private record Changes(@Nullable Expression guard, List<Update> updates) {}

  /** Compiles the guards and updates of a model, which were verified when it was read. */
  AbstractStates(TestModel model, SequenceSpec sequence) {
    Map<String, Object> first = new HashMap<>();
    for (StateVariable state : sequence.states()) {
      first.put(state.name(), Variables.plain(state.initial()));
    }
    this.initial = Map.copyOf(first);
    ExpressionCompiler overStates = new ExpressionCompiler(CaseScope.ofStates(model));
    for (SequenceStep step : sequence.steps()) {
      ExpressionCompiler overInputs =
          step instanceof SequenceCall call
              ? new ExpressionCompiler(CaseScope.ofUpdates(model, call))
              : overStates;
      List<Update> updates = new ArrayList<>();
      for (StateUpdate update : step.updates()) {
        updates.add(new Update(update.state(), overInputs.compile(update.expression())));
      }
      var guard = step.guard();
      steps.put(
          step.name(),
          new Changes(guard == null ? null : overStates.compile(guard.expression()), updates));
    }
  }

  /** The state before the first step: values for CEL by name. */
  Map<String, Object> initial() {
    return initial;
  }

  /**
   * The state after a step that ended without an error. A step that its guard forbids changes
   * nothing.
   *
   * @param inputs values of the call's inputs for CEL
   * @return empty if the state cannot be computed, so that it is unknown from now on
   */
  Optional<Map<String, Object>> after(
      Map<String, Object> before, String step, Map<String, Object> inputs) {
    Changes changes = steps.get(step);
    if (changes == null || changes.updates().isEmpty()) {
      return Optional.of(before);
    }
    try {
      Expression guard = changes.guard();
      if (guard != null && !guard.isTrue(before)) {
        return Optional.of(before);
      }
      Map<String, Object> variables = new HashMap<>(inputs);
      variables.putAll(before);
      Map<String, Object> after = new HashMap<>(before);
      for (Update update : changes.updates()) {
        after.put(update.state(), update.expression().evaluate(variables));
      }
      return Optional.of(after);
    } catch (EvaluationException e) {
      return Optional.empty();
    }
  }
}
