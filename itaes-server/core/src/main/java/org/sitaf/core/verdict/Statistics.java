package org.sitaf.core.verdict;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.model.Value;

/** Computes the summary of a result. */
public final class Statistics {
  private Statistics() {}

  /**
   * Counts verdicts and computes the times of PASS and FAIL cases.
   *
   * @param postConditions whether the model has any; if not, a case without expected values and
   *     relations is counted as unjudged
   */
  public static Summary of(List<CaseResult> cases, boolean postConditions) {
    int pass = count(cases, Verdict.PASS);
    int unjudged =
        postConditions
            ? 0
            : count(cases.stream().filter(Statistics::isUnjudged).toList(), Verdict.PASS);
    return new Summary(
        cases.size(),
        pass,
        count(cases, Verdict.FAIL),
        count(cases, Verdict.ERROR),
        count(cases, Verdict.DONT),
        unjudged,
        count(cases.stream().filter(Statistics::endedWithError).toList(), Verdict.PASS),
        times(cases));
  }

  private static boolean isUnjudged(CaseResult result) {
    return isUnjudged(result.expected())
        && result.steps().stream().allMatch(s -> isUnjudged(s.expected()))
        && result.relations().stream().noneMatch(r -> r.outcome() == RelationResult.Outcome.PASS);
  }

  private static boolean isUnjudged(List<NamedValue> expected) {
    return expected.stream().allMatch(e -> e.literal().strip().equals(Value.ANY));
  }

  /** A sequence counts if none of its calls gave a value. */
  private static boolean endedWithError(CaseResult result) {
    List<StepResult> calls = result.steps().stream().filter(s -> !s.actual().isEmpty()).toList();
    if (!result.steps().isEmpty()) {
      return !calls.isEmpty() && calls.stream().allMatch(s -> isError(s.actual()));
    }
    return isError(result.actual());
  }

  private static boolean isError(List<NamedValue> values) {
    return values.stream().anyMatch(a -> a.literal().startsWith(Value.ERROR_PREFIX));
  }

  /**
   * The times of the cases. The first call of a process also loads and compiles code, so it is left
   * out where other times remain.
   */
  private static Summary.@Nullable Times times(List<CaseResult> all) {
    List<CaseResult> timed =
        all.stream()
            .filter(c -> c.verdict() == Verdict.PASS || c.verdict() == Verdict.FAIL)
            .filter(c -> c.micros().isPresent())
            .toList();
    if (timed.isEmpty()) {
      return null;
    }
    List<CaseResult> warm = timed.stream().filter(c -> !isColdOnly(c)).toList();
    double[] times =
        (warm.isEmpty() ? timed : warm)
            .stream().mapToDouble(c -> c.micros().getAsDouble()).toArray();
    Double first =
        warm.isEmpty()
            ? null
            : timed.stream()
                .map(CaseResult::time)
                .filter(t -> t != null && t.cold())
                .map(CaseResult.ProcessingTime::total)
                .findFirst()
                .orElse(null);
    return times(times, first);
  }

  /** Whether the only call of the case was the first of its process. */
  private static boolean isColdOnly(CaseResult result) {
    CaseResult.ProcessingTime time = result.time();
    boolean repeated = result.repeated() != null && result.repeated().median() != null;
    return !repeated && time != null && time.cold();
  }

  /** Welford's algorithm, which is numerically stable for similar times. */
  private static Summary.Times times(double[] times, @Nullable Double first) {
    double min = Double.POSITIVE_INFINITY;
    double max = Double.NEGATIVE_INFINITY;
    double mean = 0;
    double squares = 0;
    for (int i = 0; i < times.length; i++) {
      double delta = times[i] - mean;
      mean += delta / (i + 1);
      squares += delta * (times[i] - mean);
      min = Math.min(min, times[i]);
      max = Math.max(max, times[i]);
    }
    double deviation = times.length > 1 ? Math.sqrt(squares / (times.length - 1)) : 0;
    return new Summary.Times(min, max, mean, deviation, first);
  }

  private static int count(List<CaseResult> cases, Verdict verdict) {
    return (int) cases.stream().filter(c -> c.verdict() == verdict).count();
  }
}
