package org.sitaf.core.flaky;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.sitaf.core.trajectory.Trace;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.NamedValue;
import org.sitaf.core.verdict.Provenance;
import org.sitaf.core.verdict.Statistics;
import org.sitaf.core.verdict.TestResult;
import org.sitaf.core.verdict.Verdict;

class FlakyCasesTest {
  private static final long STEP = 2_000_000;

  private final FlakyCases cases = new FlakyCases(10);

  private static CaseResult result(Verdict verdict, String actual, double micros, String message) {
    return new CaseResult(
        1,
        verdict,
        List.of("1"),
        List.of(),
        List.of(new NamedValue("", actual)),
        new CaseResult.ProcessingTime(micros, 0, 0),
        message);
  }

  private static CaseResult returned(Verdict verdict, String actual) {
    return result(verdict, actual, 5, "");
  }

  private void run(CaseResult result) {
    cases.add(of(result));
  }

  private void run(CaseResult result, double[] commands, double[] readings) {
    cases.signals(
        1, new Trace(0, STEP, List.of("lidar.range", "base.command"), List.of(readings, commands)));
    run(result);
  }

  private FlakyCase found() {
    assertThat(cases.find()).hasSize(1);
    return cases.find().get(0);
  }

  private static TestResult of(CaseResult result) {
    return new TestResult(
        "M",
        new Provenance("", 1, "", "", "", "", "", ""),
        Statistics.of(List.of(result), true),
        List.of(),
        List.of(result),
        null);
  }

  @Test
  void anEarlierVerdictThatNoRunConfirmsIsFlakyForAnUnknownCause() {
    cases.addEarlier(of(returned(Verdict.FAIL, "1.5")));
    run(returned(Verdict.PASS, "1.0"));
    run(returned(Verdict.PASS, "1.0"));
    assertThat(found().line())
        .isEqualTo(
            "case 1: FAIL PASS PASS; cause not known: only the build differs; the further runs are"
                + " equal");
  }

  @Test
  void anEarlierResultOfTheSameVerdictIsNotCompared() {
    cases.addEarlier(of(returned(Verdict.PASS, "1.0000001")));
    run(returned(Verdict.PASS, "1.0"));
    assertThat(cases.find()).isEmpty();
  }

  @Test
  void anEarlierCaseThatWasNotExecutedDoesNotCount() {
    cases.addEarlier(of(returned(Verdict.DONT, "")));
    run(returned(Verdict.PASS, "1.0"));
    assertThat(cases.find()).isEmpty();
  }

  @Test
  void equalRunsAreNotFlakyWhateverTheirTimesAre() {
    run(result(Verdict.PASS, "1.0", 5, ""));
    run(result(Verdict.PASS, "1.0", 50_000, ""));
    assertThat(cases.find()).isEmpty();
  }

  @Test
  void otherAddressesAndLinesInAMessageAreNotFlaky() {
    run(result(Verdict.ERROR, "", 5, "a.Lost: robot.Arm@1fc33 at robot.Arm.move(Arm.java:12)"));
    run(result(Verdict.ERROR, "", 5, "a.Lost: robot.Arm@77aa1 at robot.Arm.move(Arm.java:12)"));
    assertThat(cases.find()).isEmpty();
  }

  @Test
  void valuesThatDifferWithTheSameVerdictAreFlaky() {
    run(returned(Verdict.PASS, "1.0"));
    run(returned(Verdict.PASS, "1.5"));
    assertThat(found().cause()).isEqualTo(FlakyCause.COMPONENT);
    assertThat(found().reason()).contains("its inputs are equal");
  }

  @Test
  void aComponentThatGivesOtherCommandsAfterEqualReadingsIsTheCause() {
    run(returned(Verdict.PASS, "1.0"), new double[] {0, 1, 1, 1}, new double[] {5, 5, 4, 3});
    run(returned(Verdict.FAIL, "2.0"), new double[] {0, 1, 2, 2}, new double[] {5, 5, 3, 1});
    assertThat(found().line())
        .isEqualTo(
            "case 1: PASS FAIL; the component: its readings are equal until it gives other commands"
                + " at 0.004 s");
  }

  @Test
  void aSimulatorWhoseStatesDivergeAfterEqualCommandsIsTheCause() {
    run(returned(Verdict.PASS, "1.0"), new double[] {0, 1, 1, 1}, new double[] {5, 5, 4, 3});
    run(returned(Verdict.FAIL, "2.0"), new double[] {0, 1, 1, 2}, new double[] {5, 5, 3, 1});
    assertThat(found().cause()).isEqualTo(FlakyCause.SIMULATOR);
    assertThat(found().reason()).contains("from 0.004 s on");
  }

  @Test
  void aComponentWithEqualSignalsThatReturnsOtherValuesIsTheCause() {
    run(returned(Verdict.PASS, "1.0"), new double[] {0, 1}, new double[] {5, 5});
    run(returned(Verdict.FAIL, "2.0"), new double[] {0, 1}, new double[] {5, 5});
    assertThat(found().reason()).isEqualTo("its readings are equal, and what it returns differs");
  }

  @Test
  void aSlowCallThatExceedsTheTimeLimitNowAndThenIsTheMachines() {
    run(result(Verdict.PASS, "1.0", 6e6, ""));
    run(result(Verdict.ERROR, "", 0, "no answer within 10 s"));
    assertThat(found().cause()).isEqualTo(FlakyCause.MACHINE);
    assertThat(found().verdicts()).containsExactly(Verdict.PASS, Verdict.ERROR);
  }

  @Test
  void aFastCallThatExceedsTheTimeLimitNowAndThenMayHang() {
    run(result(Verdict.PASS, "1.0", 20, ""));
    run(result(Verdict.ERROR, "", 0, "no answer within 10 s"));
    assertThat(found().cause()).isEqualTo(FlakyCause.MACHINE);
    assertThat(found().reason()).contains("it may also hang now and then");
  }
}
