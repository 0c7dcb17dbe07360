package org.sitaf.core.compare;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sitaf.core.verdict.CaseRecord;
import org.sitaf.core.verdict.CaseRecord.Outcome;
import org.sitaf.core.verdict.StubCalls;

class ErrorTextTest {
  private static String thrown(String type, String message) {
    return ErrorText.of(
        new CaseRecord(1, Outcome.THREW, type, List.of(), StubCalls.NONE, null, message));
  }

  @Test
  void thePlaceOfAnExceptionIsLeftOut() {
    assertThat(
            thrown(
                "NoEcho",
                "robot.NoEcho: too far at robot.Arm.move(Arm.java:12), robot.Arm.go(Arm.java:3)"))
        .isEqualTo("NoEcho: too far");
    assertThat(thrown("NoEcho", "robot.b.NoEcho: too far at robot.b.Arm.lift(Arm.java:99)"))
        .isEqualTo("NoEcho: too far");
    assertThat(
            thrown(
                "ValueError",
                "ValueError: math domain error at sqrt (pkg/a.py:4), <lambda> (b.py:9)"))
        .isEqualTo("ValueError: math domain error");
    assertThat(
            thrown("ValueError", "ValueError at f (a.py:4); caused by KeyError: 'x' at g (a.py:9)"))
        .isEqualTo("ValueError");
    assertThat(thrown("out_of_range", "std::out_of_range: vector::_M_range_check"))
        .isEqualTo("out_of_range: vector::_M_range_check");
  }

  @Test
  void thePlaceOfAnErrorOutsideOfTheCallIsLeftOut() {
    assertThat(
            ErrorText.of(
                CaseRecord.error(
                    1, "TypeError: missing 'memory' at reset (ad.py:3), make (b.py:9)")))
        .isEqualTo("TypeError: missing 'memory'");
    assertThat(ErrorText.of(CaseRecord.error(1, "no answer within 1 s, at run (comp.py:5)")))
        .isEqualTo("no answer within 1 s");
  }

  @Test
  void anotherMessageOrTypeRemains() {
    assertThat(thrown("A", "A: at least 3 (not 2)")).isEqualTo("A: at least 3 (not 2)");
    assertThat(thrown("A", "A: 3.5 m/s")).isNotEqualTo(thrown("A", "A: 3.6 m/s"));
    assertThat(thrown("A", "A: x")).isNotEqualTo(thrown("B", "B: x"));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "cannot open /tmp/sitaf-run-1/build-2/data.csv:12: bad | cannot open data.csv: bad",
        "File \"/home/a/x.py\", line 12 | File \"x.py\", line",
        "Line 12: bad gain | Line: bad gain",
        "<Foo object at 0x7f12ab34> | <Foo object at 0x>",
        "Foo@1b2c3d4 failed | Foo0x failed",
        "java.lang.Object@1fc failed | java.lang.Object0x failed",
        "a.Foo$$Lambda$25/0x00007f2855007000@1c failed | a.Foo$$Lambda$25/0x0x failed",
        "a.Foo$$Lambda$25/0x00007f2855007000@254989ff failed | a.Foo$$Lambda$25/0x0x failed",
        "[D@7 and [Ljava.lang.String;@1b2c3d4 and [La.B;@2f | [D0x and [Ljava.lang.String;0x and [La.B;0x",
        "rate@50 of a@b | rate@50 of a@b",
        "in src/robot/arm.cpp:7:3 | in arm.cpp",
        "speed 3 m/s is 1/2 of 0.5 | speed 3 m/s is 1/2 of 0.5"
      })
  void foldersLinesAndAddressesAreLeftOut(String message, String normalised) {
    assertThat(ErrorText.normalised(message)).isEqualTo(normalised);
  }

  @Test
  void aHostileMessageIsNormalisedInBoundedTime() {
    for (String part : List.of("/a", " at f (", "a.", "a/", "0x", "line 1", "..", ": ")) {
      assertThat(thrown("T", part.repeat(8000 / part.length()))).isNotNull();
    }
  }

  @Test
  void aReturnIsNoError() {
    assertThat(
            ErrorText.of(
                new CaseRecord(1, Outcome.RETURNED, "", List.of(), StubCalls.NONE, null, "")))
        .isEmpty();
    assertThat(ErrorText.of(CaseRecord.error(1, ""))).isNotEmpty();
  }
}
