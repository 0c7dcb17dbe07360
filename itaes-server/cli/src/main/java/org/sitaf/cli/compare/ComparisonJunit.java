package org.sitaf.cli.compare;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.sitaf.core.compare.ComparedCase;
import org.sitaf.core.compare.Comparison;
import org.sitaf.core.compare.Difference;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.NamedValue;
import org.sitaf.core.verdict.Statistics;
import org.sitaf.core.verdict.TestResult;
import org.sitaf.core.verdict.Verdict;

/** A comparison as a test result, for reports in which a differing case is a failure. */
final class ComparisonJunit {
  private ComparisonJunit() {}

  /**
   * The result of a model in which the differing cases fail.
   *
   * @param result of the new version
   */
  static TestResult of(TestResult result, Comparison comparison) {
    String model = result.name();
    Map<Integer, List<Difference>> differences =
        comparison.differences().stream()
            .filter(d -> d.model().equals(model))
            .collect(Collectors.groupingBy(Difference::no));
    Set<Integer> compared =
        comparison.cases().stream()
            .filter(c -> c.model().equals(model))
            .map(ComparedCase::no)
            .collect(Collectors.toSet());
    List<CaseResult> cases =
        result.cases().stream()
            .map(
                judged ->
                    judged(
                        judged,
                        differences.getOrDefault(judged.no(), List.of()),
                        compared.contains(judged.no())))
            .toList();
    return new TestResult(
        result.name(),
        result.provenance(),
        Statistics.of(cases, true),
        result.parameters(),
        cases,
        null,
        result.suspicions());
  }

  private static CaseResult judged(
      CaseResult result, List<Difference> differences, boolean isCompared) {
    Verdict verdict =
        !isCompared ? Verdict.DONT : differences.isEmpty() ? Verdict.PASS : Verdict.FAIL;
    return new CaseResult(
        result.no(),
        verdict,
        result.values(),
        differences.stream().map(d -> new NamedValue(d.output(), d.base())).toList(),
        differences.stream().map(d -> new NamedValue(d.output(), d.now())).toList(),
        result.time(),
        isCompared
            ? differences.stream().map(ComparisonJunit::text).collect(Collectors.joining("; "))
            : "the case could not be compared");
  }

  private static String text(Difference difference) {
    return difference.kind().id()
        + (difference.output().isEmpty() ? "" : " " + difference.output())
        + (difference.at() == null ? "" : " at " + difference.at() + " s")
        + ": BASE "
        + difference.base()
        + ", NEW "
        + difference.now();
  }
}
