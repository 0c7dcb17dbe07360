package org.sitaf.server.result;

import io.swagger.v3.oas.annotations.media.Schema;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.suite.CaseParameter;
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
    @Schema(description = "number of cases that took more than twice the time, and 10 µs more")
        int slower,
    @Schema(description = "newly failing, fixed and slower cases, at most 300 of each")
        List<ComparedCase> items) {
  private static final int MAX_ITEMS = 300;
  private static final double SLOWER_FACTOR = 2;
  private static final double SLOWER_US = 10;

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
      @Nullable Double timeBeforeUs,
      @Nullable Double timeNowUs,
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
    List<ComparedCase> slower = new ArrayList<>();
    int common = 0;
    for (CaseResult testCase : now.cases()) {
      CaseResult previous = old.remove(testCase.values());
      if (previous == null) {
        continue;
      }
      common++;
      if (previous.verdict() == Verdict.PASS && isFailure(testCase.verdict())) {
        failing.add(compared(Change.newlyFailing, previous, testCase));
      } else if (isFailure(previous.verdict()) && testCase.verdict() == Verdict.PASS) {
        fixed.add(compared(Change.fixed, previous, testCase));
      }
      if (isSlower(previous, testCase)) {
        slower.add(compared(Change.slower, previous, testCase));
      }
    }
    slower.sort(Comparator.comparingDouble(ComparisonView::loss).reversed());
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
        items);
  }

  private static boolean isFailure(Verdict verdict) {
    return verdict == Verdict.FAIL || verdict == Verdict.ERROR;
  }

  private static boolean isSlower(CaseResult before, CaseResult now) {
    return before.time() != null
        && now.time() != null
        && now.time().total() > SLOWER_FACTOR * before.time().total()
        && now.time().total() > before.time().total() + SLOWER_US;
  }

  private static double loss(ComparedCase testCase) {
    return testCase.timeNowUs() == null || testCase.timeBeforeUs() == null
        ? 0
        : testCase.timeNowUs() - testCase.timeBeforeUs();
  }

  private static ComparedCase compared(Change change, CaseResult before, CaseResult now) {
    return new ComparedCase(
        change,
        now.no(),
        now.values(),
        before.verdict(),
        now.verdict(),
        before.time() == null ? null : before.time().total(),
        now.time() == null ? null : now.time().total(),
        now.message().isEmpty() ? null : now.message());
  }

  private static List<String> names(TestResult result) {
    return result.parameters().stream().map(CaseParameter::name).toList();
  }
}
