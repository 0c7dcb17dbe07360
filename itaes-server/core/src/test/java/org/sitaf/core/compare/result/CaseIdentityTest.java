package org.sitaf.core.compare.result;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.sitaf.core.model.InputKind;
import org.sitaf.core.suite.CaseParameter;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.NamedValue;
import org.sitaf.core.verdict.Provenance;
import org.sitaf.core.verdict.StepResult;
import org.sitaf.core.verdict.Summary;
import org.sitaf.core.verdict.TestResult;
import org.sitaf.core.verdict.Verdict;

class CaseIdentityTest {
  private static CaseResult called(int no, Verdict verdict, String... values) {
    return new CaseResult(no, verdict, List.of(values), List.of(), List.of(), null, "");
  }

  private static StepResult step(String name, String value) {
    return new StepResult(
        name,
        StepResult.Kind.VALID,
        Verdict.PASS,
        false,
        List.of(new NamedValue("input", value)),
        List.of(),
        List.of(),
        0.0,
        null,
        "",
        null,
        null);
  }

  private static List<String> fingerprints(List<String> parameters, CaseResult... cases) {
    return CaseIdentity.fingerprints(result(parameters, cases));
  }

  private static TestResult result(List<String> parameters, CaseResult... cases) {
    List<CaseParameter> declared = new ArrayList<>();
    parameters.forEach(name -> declared.add(new CaseParameter(name, InputKind.TDI, "double")));
    return new TestResult(
        "Move",
        new Provenance("aa", 1, "bb", "cc", "agent", "", "2026-01-01T00:00:00Z", ""),
        new Summary(0, 0, 0, 0, 0, 0, 0, null),
        declared,
        List.of(cases),
        null);
  }

  @Test
  void casesAreTheSameByInputsWhateverTheirNumbersAndVerdicts() {
    List<String> base =
        fingerprints(
            List.of("a", "b"), called(1, Verdict.PASS, "1", "2"), called(2, Verdict.PASS, "3", ""));
    List<String> now =
        fingerprints(
            List.of("a", "b"),
            called(1, Verdict.FAIL, "3", ""),
            called(2, Verdict.PASS, "12", ""),
            called(3, Verdict.ERROR, "1", "2"));
    assertThat(now.get(2)).isEqualTo(base.get(0)).matches("[0-9a-f]{32}");
    assertThat(now.get(0)).isEqualTo(base.get(1));
    assertThat(base).doesNotContain(now.get(1));
  }

  @Test
  void otherParametersAreOtherCases() {
    CaseResult same = called(1, Verdict.PASS, "1", "2");
    assertThat(fingerprints(List.of("a", "b"), same))
        .isNotEqualTo(fingerprints(List.of("b", "a"), same));
  }

  @Test
  void equalCasesOfAResultAreTheSameByTheirOrder() {
    List<String> found =
        fingerprints(List.of("a"), called(1, Verdict.PASS, "1"), called(2, Verdict.PASS, "1"));
    assertThat(found).doesNotHaveDuplicates();
    assertThat(fingerprints(List.of("a"), called(7, Verdict.PASS, "1")))
        .containsExactly(found.get(0));
  }

  @Test
  void sequencesAreTheSameByTheirSteps() {
    CaseResult empty = called(1, Verdict.PASS);
    String found =
        fingerprints(List.of(), empty.withSteps(List.of(step("Open", "1"), step("Read", "2"))))
            .get(0);
    assertThat(found)
        .isEqualTo(
            fingerprints(List.of(), empty.withSteps(List.of(step("Open", "1"), step("Read", "2"))))
                .get(0))
        .isNotEqualTo(fingerprints(List.of(), empty.withSteps(List.of(step("Open", "1")))).get(0))
        .isNotEqualTo(
            fingerprints(List.of(), empty.withSteps(List.of(step("Open", "2"), step("Read", "1"))))
                .get(0));
  }

  @Test
  void fingerprintsMatchTheCasesOfAComparison() {
    TestResult base =
        result(
            List.of("a"),
            called(1, Verdict.PASS, "1"),
            called(2, Verdict.PASS, "2"),
            called(3, Verdict.PASS, "1"));
    TestResult now =
        result(
            List.of("a"),
            called(1, Verdict.PASS, "1"),
            called(2, Verdict.PASS, "1"),
            called(3, Verdict.PASS, "2"));
    List<String> before = CaseIdentity.fingerprints(base);
    List<String> after = CaseIdentity.fingerprints(now);
    ResultComparison.matching(base, now)
        .forEach((no, baseNo) -> assertThat(after.get(no - 1)).isEqualTo(before.get(baseNo - 1)));
    assertThat(ResultComparison.matching(base, now)).hasSize(3);
  }
}
