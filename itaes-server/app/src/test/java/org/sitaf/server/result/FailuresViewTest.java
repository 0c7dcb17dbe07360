package org.sitaf.server.result;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.function.BiFunction;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.sitaf.core.model.InputKind;
import org.sitaf.core.suite.CaseParameter;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.Provenance;
import org.sitaf.core.verdict.Summary;
import org.sitaf.core.verdict.TestResult;
import org.sitaf.core.verdict.Verdict;

/** What a result page shows first: groups of failures, since when, and the telling parameters. */
class FailuresViewTest {
  private static final Instant NOON = Instant.parse("2026-11-24T12:00:00Z");

  /** A result of all pairs of a in 0..9 and b in 0..9, with c = (a + 3 b) mod 7. */
  private static TestResult result(BiFunction<Integer, Integer, String> failure) {
    List<CaseResult> cases = new ArrayList<>();
    for (int a = 0; a < 10; a++) {
      for (int b = 0; b < 10; b++) {
        String message = failure.apply(a, b);
        cases.add(
            new CaseResult(
                cases.size() + 1,
                message.isEmpty()
                    ? Verdict.PASS
                    : message.startsWith("!") ? Verdict.ERROR : Verdict.FAIL,
                List.of(
                    Integer.toString((a + 3 * b) % 7), Integer.toString(a), Integer.toString(b)),
                List.of(),
                List.of(),
                new CaseResult.ProcessingTime(100.0 + a, 0, 0),
                message));
      }
    }
    return new TestResult(
        "M",
        new Provenance("", 1, "", "", "", "", "", ""),
        new Summary(100, 100, 0, 0, 0, 0, 0, null),
        List.of("c", "a", "b").stream()
            .map(name -> new CaseParameter(name, InputKind.TDI, "int"))
            .toList(),
        cases,
        null);
  }

  private static FailuresView.Earlier build(int no, boolean failed) {
    return new FailuresView.Earlier("build" + no, NOON.plusSeconds(no), null, failed);
  }

  @Test
  void groupsTheFailuresAndComparesThemWithTheResultBefore() {
    TestResult before = result((a, b) -> a == 0 && b == 0 ? "!crash" : a == 9 ? "old" : "");
    TestResult now =
        result((a, b) -> a == 0 && b == 0 ? "!crash" : b > 7 ? "expected " + b + " but " + a : "");
    FailuresView view =
        FailuresView.of(
            now,
            build(5, true),
            List.of(build(4, true), build(3, true), build(2, false), build(1, true)),
            before);
    assertThat(view.groups()).hasSize(2);
    FailuresView.Group values = view.groups().get(0);
    assertThat(values.cases()).as("the largest group first").isEqualTo(20);
    assertThat(values.uniform()).isFalse();
    assertThat(values.numbers()).startsWith(9, 10, 19);
    assertThat(values.newlyFailing()).as("a=9 failed before").isEqualTo(18);
    assertThat(view.groups().get(1).verdict()).isEqualTo(Verdict.ERROR);
    assertThat(view.groups().get(1).newlyFailing()).isZero();
    assertThat(view.firstFailing()).isEqualTo(1);
    assertThat(view.before().buildId()).isEqualTo("build4");
    assertThat(view.before().newlyFailing()).isEqualTo(18);
    assertThat(view.before().stillFailing()).isEqualTo(3);
    assertThat(view.before().fixed()).isEqualTo(8);
    assertThat(view.since().buildId()).isEqualTo("build3");
    assertThat(view.since().results()).isEqualTo(3);
    assertThat(view.since().passedBefore()).isTrue();
  }

  @Test
  void aFirstResultHasNothingBefore() {
    FailuresView view = FailuresView.of(result((a, b) -> "wrong"), build(1, true), List.of(), null);
    assertThat(view.before()).isNull();
    assertThat(view.groups().get(0).newlyFailing()).isNull();
    assertThat(view.since().buildId()).isEqualTo("build1");
    assertThat(view.since().passedBefore()).isFalse();
    FailuresView passed = FailuresView.of(result((a, b) -> ""), build(1, false), List.of(), null);
    assertThat(passed.groups()).isEmpty();
    assertThat(passed.firstFailing()).isNull();
    assertThat(passed.since()).isNull();
  }

  @Test
  void listsAtMostTwentyGroups() {
    FailuresView view =
        FailuresView.of(
            result((a, b) -> "wrong " + (char) ('A' + a) + (char) ('A' + b / 2)),
            build(1, true),
            List.of(),
            null);
    assertThat(view.groups()).hasSize(20);
    assertThat(view.leftOut()).isEqualTo(30);
  }

  /** The failures depend on a and b together; c has fewer values and says nothing. */
  @Test
  void theTellingPairIsTheOneThatDecidesTheVerdict() {
    TellingPair pair = TellingPair.of(result((a, b) -> (a < 5) == (b < 5) ? "wrong" : ""));
    assertThat(pair).isNotNull();
    assertThat(List.of(pair.first(), pair.second())).containsExactly("a", "b");
    assertThat(pair.firstValues())
        .containsExactlyElementsOf(IntStream.range(0, 10).mapToObj(Integer::toString).toList());
    assertThat(pair.cells()).hasSize(100);
    assertThat(pair.cells().stream().mapToInt(TellingPair.Cell::fail).sum()).isEqualTo(50);
    assertThat(TellingPair.of(result((a, b) -> ""))).isNull();
    assertThat(TellingPair.of(result((a, b) -> "wrong"))).isNull();
  }
}
