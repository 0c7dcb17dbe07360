package org.sitaf.core.score.sequence;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Collectors;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.sequence.SequenceCall;
import org.sitaf.core.score.Effect;
import org.sitaf.core.score.Suggestions;
import org.sitaf.core.suite.TestStep;
import org.sitaf.core.verdict.StepResult;

/** What to add to a specification with sequences so that it notices a fault. */
final class SequenceSuggestions {
  private SequenceSuggestions() {}

  /**
   * A suggestion for a fault that survives.
   *
   * @param changes in cases of the suite; at least one
   */
  static String of(TestModel model, SequenceFault fault, List<ChangedCase> changes) {
    List<ChangedCase> passing = changes.stream().filter(ChangedCase::passes).toList();
    if (passing.isEmpty()) {
      return "only changes cases that do not pass without the fault, such as case "
          + changes.get(0).testCase().no();
    }
    List<Effect> effects = new ArrayList<>();
    String call = "";
    for (ChangedCase change : passing) {
      int index = change.firstStep();
      if (index >= 0) {
        TestStep step = change.testCase().steps().get(index);
        if (effects.isEmpty() || step.name().equals(call)) {
          call = step.name();
          effects.add(effect(change, index));
        }
      }
    }
    if (effects.isEmpty()) {
      return "add a trajectory condition that looks at the motion in case "
          + passing.get(0).testCase().no()
          + ", or a call that reads the effect";
    }
    Optional<SequenceCall> changed = Objects.requireNonNull(model.sequence()).call(call);
    if (changed.isEmpty()) {
      return "add a call that reads the effect of " + call + " after " + effects.get(0).label();
    }
    String where = fault.where();
    return Suggestions.of(
        changed.get().model(),
        where.startsWith(call + ".") ? where.substring(call.length() + 1) : where,
        effects);
  }

  private static Effect effect(ChangedCase change, int index) {
    TestStep step = change.testCase().steps().get(index);
    return new Effect(
        change.testCase().no(),
        "case " + change.testCase().no() + ", " + StepResult.label(index + 1, step.name()),
        step.values(),
        step.expected(),
        change.without().record().steps().get(index).record(),
        change.with().record().steps().get(index).record(),
        change.passes());
  }

  /**
   * The sequence that the suite does not have.
   *
   * @param incomplete whether the suite has more cases than were executed
   */
  static String unreached(ChangedCase change, boolean incomplete) {
    return (incomplete
            ? "none of the executed cases shows it: increase --budget, or add a case with "
            : "no case shows it: increase order or length of the sequence_spec, or add a case with ")
        + change.testCase().steps().stream()
            .map(s -> s.name() + "(" + String.join(", ", s.values()) + ")")
            .collect(Collectors.joining(", "));
  }
}
