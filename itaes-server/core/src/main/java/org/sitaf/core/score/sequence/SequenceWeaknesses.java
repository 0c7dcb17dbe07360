package org.sitaf.core.score.sequence;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.sitaf.core.model.OutputElement;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.Value;
import org.sitaf.core.model.sequence.SequenceCall;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.NamedValue;
import org.sitaf.core.verdict.StepResult;
import org.sitaf.core.verdict.Verdict;

/** Weaknesses of a specification with sequences as a whole. */
final class SequenceWeaknesses {
  private SequenceWeaknesses() {}

  /**
   * The weaknesses.
   *
   * @param results of the cases without faults
   * @param hasEffect whether a fault of a step or input changes a recorded value, by its name
   * @param notExecuted number of faults that the budget leaves out
   */
  static List<String> of(
      TestModel model,
      TestSuite suite,
      Map<Integer, CaseResult> results,
      Map<String, Boolean> hasEffect,
      int notExecuted) {
    List<String> found = new ArrayList<>();
    if (notExecuted > 0) {
      found.add(
          notExecuted
              + " faults are not counted, since they need more cases than --budget allows;"
              + " increase it");
    }
    long passing = results.values().stream().filter(r -> r.verdict() == Verdict.PASS).count();
    if (passing < suite.cases().size()) {
      found.add(
          (suite.cases().size() - passing)
              + " of "
              + suite.cases().size()
              + " cases do not pass without faults; they notice none");
    }
    for (SequenceCall call : Objects.requireNonNull(model.sequence()).calls()) {
      for (OutputElement output : call.model().outputs()) {
        if (!output.type().isVoid() && !isExpected(model, call, output, results)) {
          found.add("nothing is expected of " + call.name() + "." + output.name());
        }
      }
    }
    hasEffect.forEach(
        (where, effect) -> {
          if (!effect) {
            found.add("no recorded value depends on " + where);
          }
        });
    return found;
  }

  private static boolean isExpected(
      TestModel model, SequenceCall call, OutputElement output, Map<Integer, CaseResult> results) {
    return !model.postConditions().isEmpty()
        || call.model().postConditions().stream().anyMatch(c -> c.expression().contains("actual"))
        || results.values().stream()
            .flatMap(r -> r.steps().stream())
            .filter(s -> s.name().equals(call.name()) && s.kind() == StepResult.Kind.VALID)
            .flatMap(s -> s.expected().stream())
            .filter(e -> e.output().isEmpty() || e.output().equals(output.name()))
            .map(NamedValue::literal)
            .anyMatch(e -> !e.strip().equals(Value.ANY));
  }
}
