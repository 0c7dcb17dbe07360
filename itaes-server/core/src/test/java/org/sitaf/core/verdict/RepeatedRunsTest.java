package org.sitaf.core.verdict;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.sitaf.core.model.InvalidValues;
import org.sitaf.core.model.Strength;
import org.sitaf.core.model.Target;
import org.sitaf.core.model.TestModel;

class RepeatedRunsTest {
  private static final TestModel MODEL =
      new TestModel(
          "M",
          "",
          new Target(null, "m", null, Duration.ZERO, Duration.ZERO),
          List.of(),
          Map.of(),
          List.of(),
          List.of(),
          List.of(),
          List.of(),
          List.of(),
          List.of(),
          InvalidValues.ISOLATE,
          new Strength(2),
          List.of(),
          List.of(),
          TestModel.UNBOUNDED,
          null,
          "M.xml");

  private static TestResult run(Verdict... verdicts) {
    List<CaseResult> cases = new ArrayList<>();
    for (Verdict verdict : verdicts) {
      cases.add(
          new CaseResult(
              cases.size() + 1, verdict, List.of(), List.of(), List.of(), null, verdict.name()));
    }
    return new TestResult(
        "M",
        new Provenance("", 1, "", "", "", "", "", ""),
        Statistics.of(cases, true),
        List.of(),
        cases,
        null);
  }

  @Test
  void eachCaseHasItsWorstVerdict() {
    RepeatedRuns runs = new RepeatedRuns(MODEL);
    runs.add(run(Verdict.PASS, Verdict.PASS, Verdict.DONT, Verdict.ERROR));
    runs.add(run(Verdict.PASS, Verdict.FAIL, Verdict.PASS, Verdict.FAIL));

    assertThat(runs.result().cases())
        .extracting(CaseResult::verdict)
        .containsExactly(Verdict.PASS, Verdict.FAIL, Verdict.PASS, Verdict.ERROR);
    assertThat(runs.result().summary().fail()).isEqualTo(1);
  }

  @Test
  void anInterruptedRunReplacesNoResult() {
    RepeatedRuns runs = new RepeatedRuns(MODEL);
    runs.add(run(Verdict.PASS, Verdict.FAIL));
    runs.add(run(Verdict.PASS, Verdict.DONT));

    assertThat(runs.result().cases())
        .extracting(CaseResult::verdict)
        .containsExactly(Verdict.PASS, Verdict.FAIL);
  }
}
