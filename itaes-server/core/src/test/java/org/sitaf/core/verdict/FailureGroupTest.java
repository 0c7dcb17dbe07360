package org.sitaf.core.verdict;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

class FailureGroupTest {
  private static CaseResult result(int no, Verdict verdict, String message) {
    return new CaseResult(no, verdict, List.of(), List.of(), List.of(), null, message);
  }

  @Test
  void messagesThatDifferInNumbersAreOneGroup() {
    List<FailureGroup> groups =
        FailureGroup.of(
            List.of(
                result(1, Verdict.FAIL, "expected 0.5, but was -1.0 (allowed 1.0E-9)"),
                result(2, Verdict.PASS, ""),
                result(3, Verdict.ERROR, "NoEcho: gone\n at Sensor.java:12"),
                result(4, Verdict.FAIL, "expected 12.25, but was -1.0 (allowed 1.0E-9)"),
                result(5, Verdict.ERROR, "NoEcho: gone\n at Sensor.java:14")));

    assertThat(groups)
        .extracting(FailureGroup::message)
        .containsExactly(
            "expected 0.5, but was -1.0 (allowed 1.0E-9)",
            "NoEcho: gone\n at Sensor.java:12",
            "NoEcho: gone\n at Sensor.java:14");
    assertThat(groups).extracting(FailureGroup::isUniform).containsExactly(false, true, true);
    assertThat(groups.get(0).cases()).extracting(CaseResult::no).containsExactly(1, 4);
  }

  @Test
  void numbersWithinNamesAreNotReplaced() {
    List<FailureGroup> groups =
        FailureGroup.of(
            List.of(
                result(1, Verdict.FAIL, "ir1.range is 3"),
                result(2, Verdict.FAIL, "ir2.range is 4"),
                result(3, Verdict.ERROR, "ir1.range is 5"),
                result(4, Verdict.FAIL, "")));

    assertThat(groups).hasSize(4);
    assertThat(groups.get(0).message()).isEqualTo("ir1.range is 3");
  }

  @Test
  void exceptionsOfOneTypeFromOnePlaceAreOneGroup() {
    List<FailureGroup> groups =
        FailureGroup.of(
            List.of(
                result(1, Verdict.ERROR, "robot.NoEcho: 'left' at robot.Ir.read(Ir.java:12)"),
                result(2, Verdict.ERROR, "robot.NoEcho: 'right' at robot.Ir.read(Ir.java:12)"),
                result(3, Verdict.ERROR, "robot.NoEcho: 'left' at robot.Ir.read(Ir.java:14)"),
                result(4, Verdict.ERROR, "robot.Lost: 'left' at robot.Ir.read(Ir.java:12)"),
                result(5, Verdict.ERROR, "KeyError: 'a' at read (ir.py:3), start (ir.py:9)"),
                result(6, Verdict.ERROR, "KeyError: 'b' at read (ir.py:3), start (ir.py:9)"),
                result(7, Verdict.FAIL, "robot.NoEcho: 'left' at robot.Ir.read(Ir.java:12)")));

    assertThat(groups)
        .extracting(g -> g.cases().stream().map(CaseResult::no).toList())
        .containsExactly(List.of(1, 2), List.of(3), List.of(4), List.of(5, 6), List.of(7));
  }
}
