package org.sitaf.core.verdict;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

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

  @Test
  void aPostConditionAppliesToEveryCase() {
    List<CaseResult> cases = List.of(result(1, Verdict.PASS, List.of()));
    assertThat(Statistics.of(cases, true).unjudged()).isZero();
  }
}
