package org.sitaf.cli.compare;

import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.compare.ComparedCase;
import org.sitaf.core.compare.Comparison;
import org.sitaf.core.compare.Difference;
import org.sitaf.core.compare.NotComparable;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.NamedValue;
import org.sitaf.core.verdict.Provenance;
import org.sitaf.core.verdict.Statistics;
import org.sitaf.core.verdict.TestResult;
import org.sitaf.core.verdict.Verdict;

/** A comparison as a test result, for reports in which a differing case is a failure. */
final class ComparisonJunit {
  private ComparisonJunit() {}

  /**
   * The results of all models, in which the differing cases fail.
   *
   * @param results of the new version
   */
  static List<TestResult> of(List<TestResult> results, Comparison comparison) {
    // If nothing was compared, a report without an error would look like success.
    Verdict notCompared = comparison.cases().isEmpty() ? Verdict.ERROR : Verdict.DONT;
    List<TestResult> reported = new ArrayList<>();
    results.forEach(r -> reported.add(of(r, comparison, notCompared)));
    Set<String> executed = results.stream().map(TestResult::name).collect(Collectors.toSet());
    Map<String, List<NotComparable>> others = new LinkedHashMap<>();
    for (NotComparable reason : comparison.notComparable()) {
      if (!executed.contains(reason.model())) {
        others.computeIfAbsent(reason.model(), m -> new ArrayList<>()).add(reason);
      }
    }
    others.forEach((model, reasons) -> reported.add(notCompared(model, notCompared, reasons)));
    return reported;
  }

  private static TestResult notCompared(
      String model, Verdict verdict, List<NotComparable> reasons) {
    String message = reasons.stream().map(NotComparable::reason).collect(Collectors.joining("; "));
    List<CaseResult> cases = List.of(ofModel(verdict, List.of(), message));
    String now = Instant.now().truncatedTo(ChronoUnit.MILLIS).toString();
    return new TestResult(
        model,
        new Provenance("", 0, "", "", "", "", "", List.of(), now, now),
        Statistics.of(cases, true),
        List.of(),
        cases,
        null);
  }

  private static TestResult of(TestResult result, Comparison comparison, Verdict notCompared) {
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
    Map<Integer, String> reasons =
        comparison.notComparable().stream()
            .filter(n -> n.model().equals(model) && n.output().isEmpty())
            .collect(
                Collectors.toMap(
                    NotComparable::no, NotComparable::reason, (first, other) -> first));
    List<CaseResult> cases = new ArrayList<>();
    for (CaseResult judged : result.cases()) {
      cases.add(
          judged(
              judged,
              differences.getOrDefault(judged.no(), List.of()),
              compared.contains(judged.no()) ? null : notCompared,
              reasons.getOrDefault(
                  judged.no(), reasons.getOrDefault(0, "the case could not be compared"))));
    }
    // What only the whole model shows, such as lost coverage, has no number of a case.
    List<Difference> ofModel = differences.getOrDefault(0, List.of());
    if (!ofModel.isEmpty()) {
      cases.add(ofModel(Verdict.FAIL, ofModel, texts(ofModel)));
    }
    return new TestResult(
        result.name(),
        result.provenance(),
        Statistics.of(cases, true),
        result.parameters(),
        cases,
        null,
        result.suspicions());
  }

  private static CaseResult ofModel(Verdict verdict, List<Difference> differences, String message) {
    return new CaseResult(
        0,
        verdict,
        List.of(),
        differences.stream().map(d -> new NamedValue(d.output(), d.base())).toList(),
        differences.stream().map(d -> new NamedValue(d.output(), d.now())).toList(),
        null,
        message);
  }

  /**
   * The result of a case.
   *
   * @param notCompared verdict of a case that could not be compared; null if it was compared
   */
  private static CaseResult judged(
      CaseResult result,
      List<Difference> differences,
      @Nullable Verdict notCompared,
      String reason) {
    Verdict verdict =
        notCompared != null ? notCompared : differences.isEmpty() ? Verdict.PASS : Verdict.FAIL;
    return new CaseResult(
        result.no(),
        verdict,
        result.values(),
        differences.stream().map(d -> new NamedValue(d.output(), d.base())).toList(),
        differences.stream().map(d -> new NamedValue(d.output(), d.now())).toList(),
        result.time(),
        notCompared == null ? texts(differences) : reason);
  }

  private static String texts(List<Difference> differences) {
    return differences.stream().map(ComparisonJunit::text).collect(Collectors.joining("; "));
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
