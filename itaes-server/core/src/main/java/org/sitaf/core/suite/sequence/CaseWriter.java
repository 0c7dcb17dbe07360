package org.sitaf.core.suite.sequence;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.sitaf.core.combine.Interruption;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.ExpectedValue;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestStep;

/** Numbers planned cases and computes the expected values of their steps. */
final class CaseWriter {
  private final TestModel model;
  private final List<CompiledStep> steps;
  private final StateVariables states;
  private final Diagnostics diagnostics;
  private final Set<String> warned = new HashSet<>();

  CaseWriter(
      TestModel model, List<CompiledStep> steps, StateVariables states, Diagnostics diagnostics) {
    this.model = model;
    this.steps = steps;
    this.states = states;
    this.diagnostics = diagnostics;
  }

  /** The cases, valid ones first. Kept cases keep their numbers, which are never reused. */
  List<TestCase> write(List<PlannedCase> cases) {
    List<PlannedCase> ordered = new ArrayList<>(cases);
    ordered.sort(Comparator.comparing(c -> !c.isValid()));
    int next = cases.stream().mapToInt(PlannedCase::highestNumber).max().orElse(0) + 1;
    List<TestCase> written = new ArrayList<>();
    for (PlannedCase planned : ordered) {
      Interruption.check();
      int no = planned.number() > 0 ? planned.number() : next++;
      written.add(
          new TestCase(
              no, planned.isValid(), planned.initial().literals(), List.of(), steps(no, planned)));
    }
    return written;
  }

  private List<TestStep> steps(int no, PlannedCase planned) {
    List<TestStep> written = new ArrayList<>();
    AbstractState state = states.initial();
    for (PlannedCase.PlannedStep step : planned.steps()) {
      CompiledStep compiled = steps.get(step.kind());
      int number = written.size() + 1;
      boolean isForbidden = step.role() == PlannedCase.Role.FORBIDDEN;
      List<ExpectedValue> expected =
          isForbidden
              ? compiled.forbidden(state, number, step.row())
              : compiled.expected(state, number, step.row());
      warn(no, number, compiled, expected);
      written.add(
          new TestStep(
              compiled.step().name(),
              step.role() == PlannedCase.Role.VALID,
              step.row().literals(),
              expected));
      if (!isForbidden && !CompiledStep.isError(expected)) {
        state = after(compiled, state, step);
      }
    }
    return written;
  }

  private static AbstractState after(
      CompiledStep compiled, AbstractState state, PlannedCase.PlannedStep step) {
    try {
      return compiled.after(state, step.row());
    } catch (StepException e) {
      // An invalid value may have no state afterwards; what follows is allowed in the old one.
      return state;
    }
  }

  private void warn(int no, int number, CompiledStep compiled, List<ExpectedValue> expected) {
    for (ExpectedValue value : expected) {
      if (value.literal().startsWith(ExpectedValue.UNEVALUATED)
          && warned.add(compiled.step().name() + value.output())) {
        diagnostics.warning(
            model.source(),
            compiled.step().line(),
            "call " + compiled.step().name() + "/expected",
            "cannot be evaluated in case "
                + no
                + ", step "
                + number
                + ":"
                + value.literal().substring(ExpectedValue.UNEVALUATED.length()));
      }
    }
  }
}
