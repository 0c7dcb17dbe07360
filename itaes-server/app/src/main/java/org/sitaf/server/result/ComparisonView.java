package org.sitaf.server.result;

import io.swagger.v3.oas.annotations.media.Schema;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.suite.CaseParameter;
import org.sitaf.core.timing.TimeComparison;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.TestResult;
import org.sitaf.core.verdict.Verdict;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.result.ResultView.ParameterView;

/**
 * The differences between a result and an earlier one. Cases are matched by their values, because
 * their numbers may differ between suites.
 */
@Schema(name = "ResultComparison")
record ComparisonView(
    List<ParameterView> parameters,
    @Schema(description = "number of cases in both results") int common,
    @Schema(description = "number of cases in the earlier result only") int onlyBefore,
    @Schema(description = "number of cases in this result only") int onlyNow,
    @Schema(description = "number of cases") int newlyFailing,
    @Schema(description = "number of cases") int fixed,
    @Schema(
            description =
                "number of cases whose median of repeated calls grew by at least 10 %, with an"
                    + " adjusted p-value of the Mann-Whitney U test of at most 0.05")
        int slower,
    @Schema(description = "number of common cases whose calls were repeated in both results")
        int timed,
    @Schema(description = "why no case can be slower, and what to change; absent if cases can be")
        @Nullable String notTimed,
    @Schema(description = "newly failing, fixed and slower cases, at most 300 of each")
        List<ComparedCase> items) {
  private static final int MAX_ITEMS = 300;
  private static final String TO_GET_TIMES =
      " Repeat the calls in both: write timing: {warm_up: 3, repeat: 20} in activity.yaml, or"
          + " <timing warm_up=\"3\" repeat=\"20\"/> in the test model, and build again.";

  enum Change {
    newlyFailing,
    fixed,
    slower
  }

  @Schema(name = "ComparedCase")
  record ComparedCase(
      Change change,
      @Schema(description = "number of the case in this result") int no,
      List<String> values,
      Verdict before,
      Verdict now,
      @Schema(description = "median of repeated calls, else the time of the call")
          @Nullable Double timeBeforeUs,
      @Schema(description = "median of repeated calls, else the time of the call")
          @Nullable Double timeNowUs,
      @Schema(description = "slower cases: the median now divided by the median before")
          @Nullable Double ratio,
      @Schema(
              description =
                  "slower cases: p-value of the Mann-Whitney U test, adjusted for the number of"
                      + " compared cases")
          @Nullable Double p,
      @Nullable String message) {}

  static ComparisonView of(TestResult before, TestResult now) {
    if (!names(before).equals(names(now))) {
      throw RequestException.conflict(
          "The results cannot be compared: their parameters differ ("
              + names(before)
              + " and "
              + names(now)
              + ").");
    }
    Map<List<String>, CaseResult> old = new HashMap<>();
    before.cases().forEach(c -> old.put(c.values(), c));
    List<ComparedCase> failing = new ArrayList<>();
    List<ComparedCase> fixed = new ArrayList<>();
    List<CaseResult[]> timed = new ArrayList<>();
    int common = 0;
    for (CaseResult testCase : now.cases()) {
      CaseResult previous = old.remove(testCase.values());
      if (previous == null) {
        continue;
      }
      common++;
      if (previous.verdict() == Verdict.PASS && isFailure(testCase.verdict())) {
        failing.add(compared(Change.newlyFailing, previous, testCase, null));
      } else if (isFailure(previous.verdict()) && testCase.verdict() == Verdict.PASS) {
        fixed.add(compared(Change.fixed, previous, testCase, null));
      }
      if (isTimed(previous) && isTimed(testCase)) {
        timed.add(new CaseResult[] {previous, testCase});
      }
    }
    List<ComparedCase> slower = slower(timed);
    List<ComparedCase> items = new ArrayList<>();
    List.of(failing, fixed, slower).forEach(l -> l.stream().limit(MAX_ITEMS).forEach(items::add));
    return new ComparisonView(
        now.parameters().stream().map(ParameterView::of).toList(),
        common,
        before.cases().size() - common,
        now.cases().size() - common,
        failing.size(),
        fixed.size(),
        slower.size(),
        timed.size(),
        timed.isEmpty() ? whyNotTimed(before, now) : null,
        items);
  }

  private static boolean isFailure(Verdict verdict) {
    return verdict == Verdict.FAIL || verdict == Verdict.ERROR;
  }

  private static boolean isTimed(CaseResult result) {
    return (result.verdict() == Verdict.PASS || result.verdict() == Verdict.FAIL)
        && result.repeated() != null
        && result.repeated().calls() > 0;
  }

  /** The slower cases, the largest ratio first. */
  private static List<ComparedCase> slower(List<CaseResult[]> timed) {
    List<TimeComparison.Change> changes =
        TimeComparison.of(
            timed.stream()
                .map(
                    c ->
                        new TimeComparison.Pair(
                            Objects.requireNonNull(c[0].repeated()),
                            Objects.requireNonNull(c[1].repeated())))
                .toList());
    List<ComparedCase> slower = new ArrayList<>();
    for (int i = 0; i < changes.size(); i++) {
      if (changes.get(i).slower()) {
        slower.add(compared(Change.slower, timed.get(i)[0], timed.get(i)[1], changes.get(i)));
      }
    }
    slower.sort(
        Comparator.comparingDouble((ComparedCase c) -> c.ratio() == null ? 0 : c.ratio())
            .reversed());
    return slower;
  }

  /** A single call says nothing about the next one, so it is no evidence of a slower case. */
  private static String whyNotTimed(TestResult before, TestResult now) {
    boolean timedBefore = before.cases().stream().anyMatch(ComparisonView::isTimed);
    boolean timedNow = now.cases().stream().anyMatch(ComparisonView::isTimed);
    if (timedBefore && timedNow) {
      return "The calls of no common case were repeated in both results.";
    }
    String which =
        timedBefore ? "this result has" : timedNow ? "the other result has" : "the results have";
    return "Times are not compared, because " + which + " no repeated calls." + TO_GET_TIMES;
  }

  private static ComparedCase compared(
      Change change, CaseResult before, CaseResult now, TimeComparison.@Nullable Change times) {
    return new ComparedCase(
        change,
        now.no(),
        now.values(),
        before.verdict(),
        now.verdict(),
        micros(before),
        micros(now),
        times == null ? null : times.ratio(),
        times == null ? null : times.p(),
        now.message().isEmpty() ? null : now.message());
  }

  private static @Nullable Double micros(CaseResult result) {
    return result.micros().isEmpty() ? null : result.micros().getAsDouble();
  }

  private static List<String> names(TestResult result) {
    return result.parameters().stream().map(CaseParameter::name).toList();
  }
}
