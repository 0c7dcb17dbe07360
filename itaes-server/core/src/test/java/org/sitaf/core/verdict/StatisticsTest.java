package org.sitaf.core.verdict;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.sitaf.core.timing.RepeatedCalls;

class StatisticsTest {
  private static final List<NamedValue> EXPECTED = List.of(new NamedValue("", "1.0"));

  private static CaseResult result(int no, Verdict verdict, List<NamedValue> expected) {
    return new CaseResult(no, verdict, List.of(), expected, List.of(), null, "");
  }

  @Test
  void aCaseWithAnExpectedValueIsJudged() {
    List<CaseResult> cases =
        List.of(
            result(1, Verdict.PASS, EXPECTED),
            result(2, Verdict.PASS, List.of()),
            result(3, Verdict.ERROR, List.of()));
    assertThat(Statistics.of(cases, false).unjudged()).isEqualTo(1);
  }

  private static CaseResult timed(int no, double micros, boolean cold) {
    return new CaseResult(
        no,
        Verdict.PASS,
        List.of(),
        EXPECTED,
        List.of(),
        new CaseResult.ProcessingTime(micros, 0, 0, cold),
        "");
  }

  @Test
  void theFirstCallOfAProcessIsLeftOut() {
    Summary.Times times =
        Statistics.of(List.of(timed(1, 370, true), timed(2, 4, false), timed(3, 6, false)), false)
            .times();
    assertThat(times).isEqualTo(new Summary.Times(4, 6, 5, Math.sqrt(2), 370.0));
  }

  @Test
  void theOnlyCallIsNotLeftOut() {
    assertThat(Statistics.of(List.of(timed(1, 370, true)), false).times())
        .isEqualTo(new Summary.Times(370, 370, 370, 0));
  }

  @Test
  void theMedianOfRepeatedCallsIsTheTimeOfACase() {
    RepeatedCalls three = RepeatedCalls.of(0, new long[] {5000, 3000, 4000}, "");
    Summary.Times times =
        Statistics.of(List.of(timed(1, 370, true).with(three), timed(2, 9, false)), false).times();
    assertThat(times).isEqualTo(new Summary.Times(4, 9, 6.5, Math.sqrt(12.5), 370.0));
  }

  @Test
  void aPostConditionAppliesToEveryCase() {
    List<CaseResult> cases = List.of(result(1, Verdict.PASS, List.of()));
    assertThat(Statistics.of(cases, true).unjudged()).isZero();
  }
}
