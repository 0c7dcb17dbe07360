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
import org.sitaf.server.refusal.Refusal;
import org.sitaf.server.result.ResultView.ParameterView;

/**
 * What a result has become against an earlier one. Cases are the same when their values are: their
 * numbers may differ from suite to suite.
 */
@Schema(name = "ResultComparison")
record ComparisonView(
    List<ParameterView> parameters,
    @Schema(description = "cases that both have") int common,
    @Schema(description = "cases that only the earlier has") int onlyBefore,
    @Schema(description = "cases that only this has") int onlyNow,
    @Schema(description = "in all") int newlyFailing,
    @Schema(description = "in all") int fixed,
    @Schema(description = "in all: more than twice the time, and 10 µs more") int slower,
    @Schema(description = "newly failing, fixed, then the slowest; at most 300 of each")
        List<ComparedCase> items) {
  private static final int MAX_ITEMS = 300;
  private static final double SLOWER_FACTOR = 2;
  private static final double SLOWER_US = 10;

  /** What became of a case. */
  enum Change {
    newlyFailing,
    fixed,
    slower
  }

  @Schema(name = "ComparedCase")
  record ComparedCase(
      Change change,
      @Schema(description = "its number in this result") int no,
      List<String> values,
      Verdict before,
      Verdict now,
      @Nullable Double timeBeforeUs,
      @Nullable Double timeNowUs,
      @Nullable String message) {}

  static ComparisonView of(TestResult before, TestResult now) {
    if (!names(before).equals(names(now))) {
      throw Refusal.conflict(
          "The two results have other parameters (" + names(before) + " and " + names(now) + ").");
    }
    Map<List<String>, CaseResult> old = new HashMap<>();
    before.cases().forEach(c -> old.put(c.values(), c));
    List<ComparedCase> failing = new ArrayList<>();
    List<ComparedCase> fixed = new ArrayList<>();
    List<ComparedCase> slower = new ArrayList<>();
    int common = 0;
    for (CaseResult kase : now.cases()) {
      CaseResult was = old.remove(kase.values());
      if (was == null) {
        continue;
      }
      common++;
      if (was.verdict() == Verdict.PASS && isBad(kase.verdict())) {
        failing.add(compared(Change.newlyFailing, was, kase));
      } else if (isBad(was.verdict()) && kase.verdict() == Verdict.PASS) {
        fixed.add(compared(Change.fixed, was, kase));
      }
      if (isSlower(was, kase)) {
        slower.add(compared(Change.slower, was, kase));
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

  private static boolean isBad(Verdict verdict) {
    return verdict == Verdict.FAIL || verdict == Verdict.ERROR;
  }

  private static boolean isSlower(CaseResult was, CaseResult now) {
    return was.time() != null
        && now.time() != null
        && now.time().total() > SLOWER_FACTOR * was.time().total()
        && now.time().total() > was.time().total() + SLOWER_US;
  }

  private static double loss(ComparedCase kase) {
    return kase.timeNowUs() == null || kase.timeBeforeUs() == null
        ? 0
        : kase.timeNowUs() - kase.timeBeforeUs();
  }

  private static ComparedCase compared(Change change, CaseResult was, CaseResult now) {
    return new ComparedCase(
        change,
        now.no(),
        now.values(),
        was.verdict(),
        now.verdict(),
        was.time() == null ? null : was.time().total(),
        now.time() == null ? null : now.time().total(),
        now.message().isEmpty() ? null : now.message());
  }

  private static List<String> names(TestResult result) {
    return result.parameters().stream().map(CaseParameter::name).toList();
  }
}
