package org.sitaf.core.suite.sequence;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.model.KeptCase;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.InputValidity;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestStep;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.suite.sequence.PlannedCase.Role;

/** The sequences to keep: those of the model's {@code case_list} and those of an earlier suite. */
final class KeptSequences {
  private final TestModel model;
  private final @Nullable TestSuite earlier;
  private final SequenceVerification.Explored explored;
  private final Diagnostics diagnostics;
  private final Map<String, Integer> kinds = new HashMap<>();
  private final Map<TestModel, InputValidity> validities = new HashMap<>();

  KeptSequences(
      TestModel model,
      @Nullable TestSuite earlier,
      SequenceVerification.Explored explored,
      Diagnostics diagnostics) {
    this.model = model;
    this.earlier = earlier;
    this.explored = explored;
    this.diagnostics = diagnostics;
    for (int k = 0; k < explored.steps().size(); k++) {
      kinds.put(explored.steps().get(k).step().name(), k);
    }
  }

  /** The cases that are still allowed; others are reported and their numbers are not reused. */
  List<PlannedCase> cases() {
    List<PlannedCase> all = new ArrayList<>();
    Set<Integer> numbers = new HashSet<>();
    int highest = 0;
    for (KeptCase kept : model.keptCases()) {
      List<TestStep> steps =
          kept.steps().stream()
              .map(
                  s ->
                      new TestStep(
                          s.name(),
                          true,
                          s.values().stream().map(v -> v.literal()).toList(),
                          List.of()))
              .toList();
      highest = Math.max(highest, kept.no());
      add(
          kept.no(),
          kept.values().stream().map(v -> v.literal()).toList(),
          steps,
          kept.line(),
          numbers,
          all);
    }
    for (TestCase testCase : earlier == null ? List.<TestCase>of() : earlier.cases()) {
      highest = Math.max(highest, testCase.no());
      add(testCase.no(), testCase.values(), testCase.steps(), 0, numbers, all);
    }
    int most = highest;
    all.forEach(c -> c.setHighestNumber(most));
    return all;
  }

  private void add(
      int no,
      List<String> initial,
      List<TestStep> steps,
      int line,
      Set<Integer> numbers,
      List<PlannedCase> all) {
    Optional<PlannedCase> planned = plan(no, initial, steps, line);
    if (planned.isPresent() && (no == 0 || numbers.add(no))) {
      planned.get().setNumber(no);
      all.add(planned.get());
    }
  }

  private Optional<PlannedCase> plan(int no, List<String> initial, List<TestStep> steps, int line) {
    PlannedCase planned = new PlannedCase();
    try {
      planned.setInitial(row(model, initial));
      AbstractState state = explored.variables().initial();
      boolean failed = false;
      for (TestStep step : steps) {
        Integer kind = kinds.get(step.name());
        if (kind == null) {
          throw new IllegalArgumentException("the model has no step " + step.name());
        }
        CompiledStep compiled = explored.steps().get(kind);
        StepRow row =
            compiled.call().isPresent()
                ? row(compiled.call().get().model(), step.values())
                : StepRow.NONE;
        boolean isAllowed = compiled.isAllowed(state);
        if (!isAllowed && !compiled.hasForbidden()) {
          throw new IllegalArgumentException(
              "step "
                  + step.name()
                  + " is not allowed in ("
                  + explored.variables().text(state)
                  + ")");
        }
        Role role = !isAllowed ? Role.FORBIDDEN : row.isValid() ? Role.VALID : Role.INVALID_ROW;
        if (role != Role.VALID && failed) {
          throw new IllegalArgumentException("two steps are forbidden or hold invalid values");
        }
        failed |= role != Role.VALID;
        planned.add(kind, row, role);
        if (isAllowed
            && !CompiledStep.isError(compiled.expected(state, planned.steps().size(), row))) {
          state = compiled.after(state, row);
        }
      }
      if (steps.isEmpty()
          || steps.size() > java.util.Objects.requireNonNull(model.sequence()).length()) {
        throw new IllegalArgumentException(
            "it has "
                + steps.size()
                + " steps, but length allows 1 to "
                + model.sequence().length());
      }
      return Optional.of(planned);
    } catch (IllegalArgumentException | StepException e) {
      diagnostics.warning(
          model.source(),
          line,
          "case " + no,
          "is dropped, and its number is not reused: " + e.getMessage());
      return Optional.empty();
    }
  }

  private StepRow row(TestModel of, List<String> literals) {
    return StepRow.of(
        of, literals, false, validities.computeIfAbsent(of, m -> new InputValidity(m, 1)));
  }
}
