package org.sitaf.core.suite.sequence;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.diagnostic.Diagnostic;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.expression.Expression;
import org.sitaf.core.expression.ExpressionCompiler;
import org.sitaf.core.expression.type.Type;
import org.sitaf.core.model.Condition;
import org.sitaf.core.model.OutputElement;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.sequence.SequenceCall;
import org.sitaf.core.model.sequence.SequenceSpec;
import org.sitaf.core.model.sequence.SequenceStep;
import org.sitaf.core.model.sequence.StateUpdate;
import org.sitaf.core.model.sequence.StateVariable;
import org.sitaf.core.suite.CaseScope;
import org.sitaf.core.suite.Conditions;
import org.sitaf.core.suite.ExpectedText;

/** Compiles the expressions of all steps of a model and reports their problems. */
final class SequenceCompiler {
  private final TestModel model;
  private final SequenceSpec sequence;
  private final Diagnostics diagnostics;
  private final StateVariables states;
  private final Set<String> mentioned = new HashSet<>();

  SequenceCompiler(TestModel model, Diagnostics diagnostics) {
    this.model = model;
    this.sequence = Objects.requireNonNull(model.sequence());
    this.diagnostics = diagnostics;
    this.states = new StateVariables(sequence.states());
  }

  StateVariables states() {
    return states;
  }

  /** The steps in the order of {@link SequenceSpec#steps()}. */
  List<CompiledStep> compile() {
    sequence.states().forEach(this::initial);
    Set<Diagnostic> reported = new HashSet<>();
    List<CompiledStep> steps = new ArrayList<>();
    for (SequenceStep step : sequence.steps()) {
      Expression guard = guard(step);
      List<CompiledStep.Update> updates = new ArrayList<>();
      for (StateUpdate update : step.updates()) {
        update(step, update).ifPresent(updates::add);
      }
      Map<String, Expression> expected = Map.of();
      Expression forbidden = null;
      if (step instanceof SequenceCall call) {
        Diagnostics own = new Diagnostics();
        Conditions conditions = Conditions.compile(call.model(), own);
        own.all().stream().filter(reported::add).forEach(d -> diagnostics.addAll(List.of(d)));
        expected = conditions.expected();
        expected.values().forEach(e -> mentioned.addAll(e.variables()));
        conditions.post().forEach(e -> mentioned.addAll(e.variables()));
        forbidden = forbidden(call);
      }
      steps.add(new CompiledStep(states, step, guard, updates, expected, forbidden));
    }
    for (StateVariable state : sequence.states()) {
      if (!diagnostics.hasErrors() && !mentioned.contains(state.name())) {
        diagnostics.warning(
            model.source(),
            state.line(),
            "state " + state.name(),
            "is never used: no guard, update, expected value or condition reads it; use it or"
                + " remove it");
      }
    }
    return steps;
  }

  private void initial(StateVariable state) {
    try {
      var unused = StateVariables.initial(state);
    } catch (IllegalArgumentException e) {
      error(state.line(), "state " + state.name() + "/initial", String.valueOf(e.getMessage()));
    }
  }

  private static String where(SequenceStep step) {
    return (step instanceof SequenceCall ? "call " : "event ") + step.name();
  }

  private @Nullable Expression guard(SequenceStep step) {
    Condition guard = step.guard();
    if (guard == null) {
      return null;
    }
    String where = where(step) + "/guard";
    Expression compiled =
        compile(new ExpressionCompiler(CaseScope.ofStates(model)), guard, where).orElse(null);
    if (compiled != null && !compiled.type().equals(Type.BOOLEAN) && !compiled.type().isOpen()) {
      error(
          guard.line(),
          where,
          "'"
              + compiled.text()
              + "' must be true or false, but its type is "
              + compiled.type().name());
      return null;
    }
    return compiled;
  }

  private Optional<CompiledStep.Update> update(SequenceStep step, StateUpdate update) {
    String where = where(step) + "/update";
    ExpressionCompiler compiler =
        new ExpressionCompiler(
            step instanceof SequenceCall call
                ? CaseScope.ofUpdates(model, call)
                : CaseScope.ofStates(model));
    int state = states.index(update.state());
    Optional<Expression> compiled =
        compile(compiler, new Condition(update.expression(), update.line()), where);
    if (compiled.isEmpty() || state < 0) {
      return Optional.empty();
    }
    StateVariable variable = sequence.states().get(state);
    Type wanted = Type.of(variable.type());
    Type given = compiled.get().type();
    boolean isWhole = wanted.equals(Type.WHOLE) && given.equals(Type.REAL);
    if (isWhole || Type.join(wanted, given) == null) {
      error(
          update.line(),
          where,
          "the type of '"
              + compiled.get().text()
              + "' is "
              + given.name()
              + ", but the state "
              + variable.name()
              + " is "
              + variable.realType());
      return Optional.empty();
    }
    return Optional.of(new CompiledStep.Update(state, compiled.get(), update));
  }

  private @Nullable Expression forbidden(SequenceCall call) {
    Condition outcome = call.forbidden();
    if (outcome == null) {
      return null;
    }
    String where = where(call) + "/forbidden";
    Expression compiled =
        compile(
                new ExpressionCompiler(CaseScope.beforeCall(call.model())),
                new Condition(ExpectedText.expression(outcome.expression()), outcome.line()),
                where)
            .orElse(null);
    Optional<OutputElement> returned = call.model().output(OutputElement.RETURN_NAME);
    if (compiled != null && returned.isPresent()) {
      ExpectedText.problem(compiled, returned.get().type())
          .ifPresent(problem -> error(outcome.line(), where, problem));
    }
    return compiled;
  }

  private Optional<Expression> compile(ExpressionCompiler compiler, Condition text, String where) {
    try {
      Expression compiled = compiler.compile(text.expression());
      mentioned.addAll(compiled.variables());
      return Optional.of(compiled);
    } catch (IllegalArgumentException e) {
      error(text.line(), where, String.valueOf(e.getMessage()));
      return Optional.empty();
    }
  }

  private void error(int line, String where, String message) {
    diagnostics.error(model.source(), line, where, message);
  }
}
