package org.sitaf.core.score;

import java.util.ArrayList;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.Map;
import org.sitaf.core.model.OutputElement;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.Value;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.Literals;
import org.sitaf.core.verdict.Verdict;

/** Weaknesses of a specification as a whole. */
final class Weaknesses {
  private final TestModel model;
  private final Map<Integer, CaseResult> results;
  private final List<String> found = new ArrayList<>();

  private Weaknesses(TestModel model, Map<Integer, CaseResult> results) {
    this.model = model;
    this.results = results;
  }

  /**
   * The weaknesses.
   *
   * @param results of the cases without faults
   * @param hasEffect whether a fault of an input changes a recorded value, by the input's name
   */
  static List<String> of(
      TestModel model,
      TestSuite suite,
      Map<Integer, CaseResult> results,
      Map<String, Boolean> hasEffect) {
    Weaknesses all = new Weaknesses(model, results);
    all.notPassing(suite);
    all.maskedByErrors();
    model.outputs().stream().filter(o -> !o.type().isVoid()).forEach(all::ofOutput);
    hasEffect.forEach(
        (input, effect) -> {
          if (!effect) {
            all.found.add("no recorded value depends on " + input);
          }
        });
    return all.found;
  }

  private void notPassing(TestSuite suite) {
    long passing = results.values().stream().filter(r -> r.verdict() == Verdict.PASS).count();
    if (passing < suite.cases().size()) {
      found.add(
          (suite.cases().size() - passing)
              + " of "
              + suite.cases().size()
              + " cases do not pass without faults; they notice none");
    }
  }

  private void maskedByErrors() {
    List<CaseResult> passing =
        results.values().stream().filter(r -> r.verdict() == Verdict.PASS).toList();
    long errors =
        passing.stream()
            .filter(
                r -> r.actual().stream().anyMatch(a -> a.literal().startsWith(Value.ERROR_PREFIX)))
            .count();
    if (errors > 0 && errors * 2 > passing.size()) {
      found.add(
          errors
              + " of "
              + passing.size()
              + " passing cases end with an error, which hides values");
    }
  }

  private static boolean expects(OutputElement output, CaseResult result) {
    return result.expected().stream()
        .filter(e -> e.output().isEmpty() || e.output().equals(output.name()))
        .anyMatch(e -> !e.literal().strip().equals(Value.ANY));
  }

  private void ofOutput(OutputElement output) {
    if (results.values().stream().noneMatch(r -> expects(output, r))
        && model.postConditions().stream().noneMatch(c -> c.expression().contains("actual"))
        && model.relations().isEmpty()) {
      found.add("nothing is expected of " + output.name());
      return;
    }
    DoubleSummaryStatistics numbers =
        results.values().stream()
            .flatMap(r -> r.actual().stream())
            .filter(a -> a.output().isEmpty() || a.output().equals(output.name()))
            .filter(a -> Literals.isReal(a.literal()))
            .mapToDouble(a -> Literals.real(a.literal()))
            .filter(Double::isFinite)
            .summaryStatistics();
    double range = numbers.getMax() - numbers.getMin();
    if (numbers.getCount() > 1 && range > 0 && output.tolerance().absolute() >= range) {
      found.add(
          "the tolerance of "
              + output.name()
              + ", "
              + output.tolerance().absolute()
              + ", is wider than the range of its values, "
              + range);
    }
  }
}
