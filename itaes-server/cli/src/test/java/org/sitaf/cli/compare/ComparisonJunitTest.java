package org.sitaf.cli.compare;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.sitaf.core.compare.ComparedCase;
import org.sitaf.core.compare.Comparison;
import org.sitaf.core.compare.Difference;
import org.sitaf.core.compare.DifferenceClass;
import org.sitaf.core.compare.NotComparable;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.Provenance;
import org.sitaf.core.verdict.Statistics;
import org.sitaf.core.verdict.TestResult;
import org.sitaf.core.verdict.Verdict;
import org.sitaf.core.verdict.document.JunitXml;

class ComparisonJunitTest {
  private static final Difference LOST =
      new Difference(
          "Drive",
          0,
          true,
          DifferenceClass.COVERAGE_LOST,
          "arm.py",
          Map.of(),
          "executes lines 5-6",
          "does not execute them",
          null,
          "",
          0);

  private static String report(List<TestResult> results, Comparison comparison) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    JunitXml.write("robot", ComparisonJunit.of(results, comparison), out);
    return out.toString(UTF_8);
  }

  private static TestResult result() {
    List<CaseResult> cases =
        List.of(new CaseResult(1, Verdict.PASS, List.of(), List.of(), List.of(), null, ""));
    Provenance provenance = new Provenance("", 1, "", "", "", "", "", List.of(), "", "");
    return new TestResult("Drive", provenance, Statistics.of(cases, true), List.of(), cases, null);
  }

  private static Comparison comparison(
      List<ComparedCase> cases, List<Difference> differences, List<NotComparable> not) {
    return new Comparison(cases, differences, List.of(), List.of(), List.of(), not);
  }

  @Test
  void lostCoverageIsAFailure() {
    String report =
        report(
            List.of(result()),
            comparison(List.of(new ComparedCase("Drive", 1, Map.of())), List.of(LOST), List.of()));

    assertThat(report)
        .contains("tests=\"2\" failures=\"1\"")
        .contains("name=\"all cases\"")
        .contains("executes lines 5-6");
  }

  @Test
  void aModelIsAnErrorIfNothingWasCompared() {
    NotComparable reason = new NotComparable("Drive", 0, "", "the sources do not compile");

    assertThat(report(List.of(), comparison(List.of(), List.of(), List.of(reason))))
        .contains("name=\"robot.Drive\" tests=\"1\" failures=\"0\" errors=\"1\"")
        .contains("the sources do not compile");
  }

  @Test
  void aModelIsSkippedIfAnotherOneWasCompared() {
    NotComparable reason = new NotComparable("Turn", 0, "", "BASE has no method Turn");

    assertThat(
            report(
                List.of(result()),
                comparison(
                    List.of(new ComparedCase("Drive", 1, Map.of())), List.of(), List.of(reason))))
        .contains("name=\"robot.Turn\" tests=\"1\" failures=\"0\" errors=\"0\" skipped=\"1\"");
  }

  @Test
  void aCaseSaysWhyItWasNotCompared() {
    NotComparable reason = new NotComparable("Drive", 1, "", "not executed with BASE");

    assertThat(
            report(
                List.of(result()),
                comparison(
                    List.of(new ComparedCase("Turn", 1, Map.of())), List.of(), List.of(reason))))
        .contains("<skipped message=\"not executed with BASE\">");
  }

  @Test
  void casesAreErrorsIfNothingWasCompared() {
    NotComparable reason = new NotComparable("Drive", 1, "", "not executed with BASE");

    assertThat(report(List.of(result()), comparison(List.of(), List.of(), List.of(reason))))
        .contains("tests=\"1\" failures=\"0\" errors=\"1\" skipped=\"0\"")
        .contains("not executed with BASE");
  }

  @Test
  void theReasonOfAModelIsThatOfItsCases() {
    NotComparable reason = new NotComparable("Drive", 0, "", "BASE has no method Drive");

    assertThat(report(List.of(result()), comparison(List.of(), List.of(), List.of(reason))))
        .contains("errors=\"1\"")
        .contains("BASE has no method Drive");
  }
}
