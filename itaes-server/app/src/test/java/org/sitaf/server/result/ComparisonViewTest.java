package org.sitaf.server.result;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.function.IntFunction;
import java.util.stream.IntStream;
import java.util.stream.LongStream;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.sitaf.core.timing.RepeatedCalls;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.Provenance;
import org.sitaf.core.verdict.Summary;
import org.sitaf.core.verdict.TestResult;
import org.sitaf.core.verdict.Verdict;

/** Slower cases of a comparison. */
class ComparisonViewTest {
  private static final int CASES = 10;

  /** A result of passed cases whose single call takes longer with each case. */
  private static TestResult result(IntFunction<@Nullable RepeatedCalls> repeated) {
    List<CaseResult> cases =
        IntStream.rangeClosed(1, CASES)
            .mapToObj(
                no -> {
                  CaseResult single =
                      new CaseResult(
                          no,
                          Verdict.PASS,
                          List.of(Integer.toString(no)),
                          List.of(),
                          List.of(),
                          new CaseResult.ProcessingTime(100.0 * no, 0, 0),
                          "");
                  RepeatedCalls calls = repeated.apply(no);
                  return calls == null ? single : single.with(calls);
                })
            .toList();
    return new TestResult(
        "M",
        new Provenance("", 1, "", "", "", "", "", ""),
        new Summary(CASES, CASES, 0, 0, 0, 0, 0, null),
        List.of(),
        cases,
        null);
  }

  private static RepeatedCalls calls(long nanos, String differs) {
    return RepeatedCalls.of(
        3, LongStream.range(0, 20).map(i -> nanos + 37 * i % 200).toArray(), differs);
  }

  @Test
  void aCaseIsSlowerByItsRepeatedCalls() {
    TestResult before = result(no -> calls(4000, ""));
    TestResult now = result(no -> calls(no == 7 ? 6000 : no == 9 ? 8000 : 4100, ""));
    ComparisonView comparison = ComparisonView.of(before, now);
    assertThat(comparison.slower()).isEqualTo(2);
    assertThat(comparison.timed()).isEqualTo(CASES);
    assertThat(comparison.notTimed()).isNull();
    assertThat(comparison.items())
        .extracting(ComparisonView.ComparedCase::no)
        .as("the largest ratio first")
        .containsExactly(9, 7);
    ComparisonView.ComparedCase slower = comparison.items().get(1);
    assertThat(slower.change()).isEqualTo(ComparisonView.Change.slower);
    assertThat(slower.ratio()).isEqualTo(1.5, within(0.05));
    assertThat(slower.p()).isLessThan(1e-5);
    assertThat(slower.timeBeforeUs()).isEqualTo(4.1, within(0.05));
  }

  @Test
  void aSingleCallIsNoEvidence() {
    TestResult timed = result(no -> calls(4000, ""));
    TestResult single = result(no -> null);
    assertThat(ComparisonView.of(single, single).notTimed())
        .startsWith("Times are not compared, because the results have no repeated calls.")
        .contains("timing: {warm_up: 3, repeat: 20}");
    assertThat(ComparisonView.of(single, timed).notTimed())
        .contains("because the other result has no repeated calls");
    assertThat(ComparisonView.of(timed, single).notTimed())
        .contains("because this result has no repeated calls");
    assertThat(ComparisonView.of(single, timed).slower()).isZero();
  }

  @Test
  void onlyCasesWithRepeatedCallsInBothResultsAreCompared() {
    TestResult odd = result(no -> no % 2 == 1 ? calls(4000, "") : null);
    TestResult even = result(no -> no % 2 == 0 ? calls(9000, "") : null);
    assertThat(ComparisonView.of(odd, even).notTimed())
        .isEqualTo("The calls of no common case were repeated in both results.");
  }

  @Test
  void repeatedCallsOfACaseAreShown() {
    RepeatedCalls calls = calls(4000, "call 9: return is 1, not 2");
    CaseView view = CaseView.of(result(no -> calls).cases().get(0));
    assertThat(view.processingTimeUs()).isEqualTo(100);
    CaseView.RepeatedView repeated = view.repeated();
    assertThat(repeated.calls()).isEqualTo(20);
    assertThat(repeated.medianUs()).isBetween(repeated.lowUs(), repeated.highUs());
    assertThat(repeated.differs()).isEqualTo("call 9: return is 1, not 2");
  }
}
