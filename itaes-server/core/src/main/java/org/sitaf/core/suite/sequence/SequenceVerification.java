package org.sitaf.core.suite.sequence;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashSet;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.combine.Effort;
import org.sitaf.core.combine.TooManyCombinationsException;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.ScalarType;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.sequence.SequenceCall;
import org.sitaf.core.model.sequence.SequenceSpec;
import org.sitaf.core.model.sequence.StateVariable;
import org.sitaf.core.suite.GenerationOptions;
import org.sitaf.core.suite.TestStep;

/** Explores the abstract states of a model and reports what no sequence reaches. */
public final class SequenceVerification {
  private SequenceVerification() {}

  /** Compiles all expressions of a sequence, explores its states, and reports all problems. */
  public static void verify(TestModel model, Diagnostics diagnostics) {
    try {
      var unused = explore(model, GenerationOptions.DEFAULT, diagnostics);
    } catch (InvalidInputException e) {
      diagnostics.addAll(e.diagnostics());
    }
  }

  /**
   * The valid steps of a model: its events, and its calls with each of their rows of values.
   *
   * @param seed of the values
   * @return empty if the model has errors
   */
  public static Optional<List<TestStep>> steps(TestModel model, long seed) {
    GenerationOptions options = new GenerationOptions(null, null, seed, Effort.DEFAULT);
    Explored explored;
    try {
      explored = explore(model, options, new Diagnostics());
    } catch (InvalidInputException e) {
      return Optional.empty();
    }
    if (explored == null) {
      return Optional.empty();
    }
    List<TestStep> steps = new ArrayList<>();
    for (int kind = 0; kind < explored.steps().size(); kind++) {
      String name = explored.steps().get(kind).step().name();
      for (StepRow row : explored.rows().get(kind).choices()) {
        steps.add(new TestStep(name, true, row.literals(), List.of()));
      }
    }
    return Optional.of(steps);
  }

  /** The steps of a model, their rows, and the states that they reach. */
  record Explored(
      StateVariables variables, List<CompiledStep> steps, List<StepRows> rows, StateSpace space) {}

  /** Null if there are errors. */
  static @Nullable Explored explore(
      TestModel model, GenerationOptions options, Diagnostics diagnostics) {
    SequenceSpec sequence = Objects.requireNonNull(model.sequence());
    SequenceCompiler compiler = new SequenceCompiler(model, diagnostics);
    List<CompiledStep> steps = compiler.compile();
    if (diagnostics.hasErrors()) {
      return null;
    }
    List<StepRows> rows = new ArrayList<>();
    for (CompiledStep step : steps) {
      SequenceCall call = step.call().orElse(null);
      try {
        rows.add(
            call == null
                ? StepRows.NONE
                : StepRows.of(call.model(), step.relevantInputs(), options, diagnostics));
      } catch (InvalidInputException e) {
        e.diagnostics()
            .forEach(
                d ->
                    diagnostics.error(
                        d.file(),
                        d.line() == 0 ? step.step().line() : d.line(),
                        "call " + step.step().name() + "/" + d.element(),
                        d.message()));
      }
    }
    if (diagnostics.hasErrors()) {
      return null;
    }
    for (int kind = 0; kind < steps.size(); kind++) {
      if (rows.get(kind).valid().isEmpty()) {
        diagnostics.error(
            model.source(),
            steps.get(kind).step().line(),
            "call " + steps.get(kind).step().name(),
            "has no valid row of values, so no sequence holds it; add a valid value");
      }
    }
    if (diagnostics.hasErrors()) {
      return null;
    }
    StateSpace space;
    try {
      space = new StateSpace(compiler.states().initial(), steps, rows, sequence.length());
    } catch (StepException e) {
      diagnostics.error(model.source(), e.line(), e.where(), String.valueOf(e.getMessage()));
      return null;
    } catch (IllegalStateException | TooManyCombinationsException e) {
      diagnostics.error(
          model.source(), sequence.line(), "sequence_spec", String.valueOf(e.getMessage()));
      return null;
    }
    reach(model, sequence, steps, space, diagnostics);
    return diagnostics.hasErrors() ? null : new Explored(compiler.states(), steps, rows, space);
  }

  private static void reach(
      TestModel model,
      SequenceSpec sequence,
      List<CompiledStep> steps,
      StateSpace space,
      Diagnostics diagnostics) {
    BitSet allowed = new BitSet();
    for (int s = 0; s < space.size(); s++) {
      for (int kind = 0; kind < steps.size(); kind++) {
        allowed.set(kind, allowed.get(kind) || space.machine().allows(s, kind));
      }
    }
    for (int kind = 0; kind < steps.size(); kind++) {
      CompiledStep step = steps.get(kind);
      boolean isCall = step.call().isPresent();
      if (!allowed.get(kind)) {
        diagnostics.error(
            model.source(),
            step.step().guard() == null
                ? step.step().line()
                : Objects.requireNonNull(step.step().guard()).line(),
            (isCall ? "call " : "event ") + step.step().name() + "/guard",
            "no state that "
                + sequence.length()
                + " steps reach allows it; correct the guard, or the updates that should make it"
                + " true");
      } else if (step.hasForbidden() && isAlwaysAllowed(space, step)) {
        diagnostics.warning(
            model.source(),
            Objects.requireNonNull(step.call().orElseThrow().forbidden()).line(),
            "call " + step.step().name() + "/forbidden",
            "has no effect: the guard is true in every state that a sequence reaches");
      }
    }
    for (int v = 0; v < sequence.states().size(); v++) {
      values(model, sequence.states().get(v), v, space, diagnostics);
    }
  }

  private static boolean isAlwaysAllowed(StateSpace space, CompiledStep step) {
    for (int s = 0; s < space.size(); s++) {
      if (!step.isAllowed(space.state(s))) {
        return false;
      }
    }
    return true;
  }

  /** Values of booleans and enumerations that no sequence reaches. */
  private static void values(
      TestModel model,
      StateVariable variable,
      int index,
      StateSpace space,
      Diagnostics diagnostics) {
    List<String> possible =
        variable.type() instanceof DataType.Enumeration enumeration
            ? enumeration.literals()
            : variable.type() instanceof DataType.Scalar scalar
                    && scalar.type() == ScalarType.BOOLEAN
                ? List.of("false", "true")
                : List.of();
    Set<String> reached = new HashSet<>();
    for (int s = 0; s < space.size(); s++) {
      reached.add(space.state(s).literals().get(index));
    }
    List<String> missing = possible.stream().filter(p -> !reached.contains(p)).toList();
    if (!missing.isEmpty()) {
      diagnostics.warning(
          model.source(),
          variable.line(),
          "state " + variable.name(),
          "no sequence reaches the value "
              + String.join(", ", missing)
              + "; add an update that sets it, or increase length");
    }
  }
}
