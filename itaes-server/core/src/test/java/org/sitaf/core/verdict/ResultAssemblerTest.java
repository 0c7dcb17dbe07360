package org.sitaf.core.verdict;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.sitaf.core.activity.lock.ResolvedPackage;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.document.TestModelXml;
import org.sitaf.core.suite.GenerationOptions;
import org.sitaf.core.suite.TestCaseGenerator;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.timing.RepeatedCalls;
import org.sitaf.core.verdict.document.JunitXml;
import org.sitaf.core.verdict.document.TestResultXml;

class ResultAssemblerTest {
  private static final String MODEL =
      """
      <test_model>
        <name>Half</name>
        <input_spec_list>
          <test_element abstract_type="NUMERIC" real_type="int"><name>n</name><type>TDI</type>
            <user_value_list><value>0</value><value>2</value><value>4</value></user_value_list>
          </test_element>
        </input_spec_list>
        <output_spec_list>
          <test_element abstract_type="NUMERIC" real_type="double"><name>return</name><type>RETURN</type></test_element>
        </output_spec_list>
        <post_condition_spec_list>
          <post_condition>actual * 2.0 == n</post_condition>
          <post_condition>n == 0 || 4 / n &lt;= 2</post_condition>
        </post_condition_spec_list>
        <order_of_combinations>1</order_of_combinations>
      </test_model>
      """;
  private static final Provenance PROVENANCE =
      new Provenance(
          "s",
          1,
          "h",
          "c",
          "",
          "",
          "Python 3.11.2",
          List.of(new ResolvedPackage("numpy", "2.4.6", "ab")),
          "2026-01-01T00:00:00Z",
          "2026-01-01T00:00:01Z");

  private final TestModel model = read();
  private final TestSuite suite =
      TestCaseGenerator.generate(model, GenerationOptions.DEFAULT).suite();
  private final ResultAssembler assembler = new ResultAssembler(model, suite);

  private static TestModel read() {
    return TestModelXml.read(
        new ByteArrayInputStream(MODEL.getBytes(StandardCharsets.UTF_8)), "Half.xml");
  }

  private static CaseRecord returned(int no, String actual, double time) {
    return new CaseRecord(
        no,
        CaseRecord.Outcome.RETURNED,
        "",
        List.of(new NamedValue("return", actual)),
        StubCalls.NONE,
        new CaseResult.ProcessingTime(time, 1, 0),
        "");
  }

  private CaseResult first() {
    return assembler.judge(returned(1, "0", 2));
  }

  @Test
  void aViolatedPostConditionFailsACaseWithTheExpectedValue() {
    CaseResult judged = assembler.judge(returned(2, "1.5", 1));
    assertThat(judged.verdict()).isEqualTo(Verdict.FAIL);
    assertThat(judged.message()).isEqualTo("post-condition violated: actual * 2.0 == n: 3.0 == 2");
  }

  @Tag("slow")
  @Test
  void aTooExpensiveConditionIsAnError() {
    String all = "actual.all(a, actual.all(b, actual.all(c, actual.all(d, a + b + c + d > -1))))";
    String costly =
        MODEL
            .replace("actual * 2.0 == n", all.replace(">", "&gt;"))
            .replace(
                "abstract_type=\"NUMERIC\" real_type=\"double\"><name>return",
                "abstract_type=\"SEQUENCE\" real_type=\"sequence&lt;long&gt;\"><name>return");
    TestModel other =
        TestModelXml.read(
            new ByteArrayInputStream(costly.getBytes(StandardCharsets.UTF_8)), "Half.xml");
    String ones = java.util.Collections.nCopies(200, "1").toString();
    ResultAssembler judge = new ResultAssembler(other, suite);
    for (int i = 0; i < 3; i++) {
      CaseResult judged = judge.judge(returned(2, ones, 1));
      assertThat(judged.verdict()).isEqualTo(Verdict.ERROR);
      assertThat(judged.message()).contains("more than 5,000,000 steps", "simplify it");
    }
    CaseResult judged = judge.judge(returned(3, "[1]", 1));
    assertThat(judged.verdict()).isEqualTo(Verdict.ERROR);
    assertThat(judged.message())
        .contains("exceeded the limits of an evaluation in 3 cases", "(Half.xml:");
  }

  @Test
  void aConditionThatCannotBeEvaluatedIsAnError() {
    CaseResult judged = assembler.judge(returned(2, "one", 1));
    assertThat(judged.verdict()).isEqualTo(Verdict.ERROR);
    int line = (int) MODEL.substring(0, MODEL.indexOf("actual * 2.0")).lines().count();
    assertThat(judged.message())
        .startsWith("post-condition cannot be evaluated: actual * 2.0 == n: ")
        .contains("(Half.xml:" + line + ")");
  }

  @Test
  void countsAllCasesAndTheTimesOfPassAndFail() {
    List<CaseResult> results = List.of(first(), assembler.judge(returned(2, "7", 4)));
    TestResult result = assembler.assemble(results, "the agent was stopped", PROVENANCE);
    Summary summary = result.summary();
    assertThat(summary.total()).isEqualTo(3);
    assertThat(List.of(summary.pass(), summary.fail(), summary.error(), summary.dont()))
        .containsExactly(1, 1, 0, 1);
    assertThat(result.cases().get(2).message()).isEqualTo("the agent was stopped");
    assertThat(summary.times().average()).isEqualTo(3);
    assertThat(summary.times().standardDeviation()).isCloseTo(Math.sqrt(2), within(1e-12));
    assertThat(summary.unjudged()).isZero();
  }

  @Test
  void readsAWrittenResultUnchanged() {
    TestResult result =
        assembler.assemble(
            List.of(first().withVerdict(Verdict.FAIL, "a\rb \"<&")), "why not", PROVENANCE);
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    TestResultXml.write(result, out);
    assertThat(TestResultXml.read(new ByteArrayInputStream(out.toByteArray()), "result.xml"))
        .isEqualTo(result);
  }

  @Test
  void readsRepeatedCallsOfAWrittenResultUnchanged() {
    CaseResult first =
        new CaseResult(
            1,
            Verdict.PASS,
            List.of(),
            List.of(),
            List.of(),
            new CaseResult.ProcessingTime(370, 1, 2, true),
            "");
    long[] nanos = {5001, 3000, 4000, 3999, 5001, 8000, 12};
    List<CaseResult> cases =
        List.of(
            first.with(RepeatedCalls.of(3, nanos, "call 9: return is 1, not 0")),
            first.with(RepeatedCalls.of(3, new long[0], "")));
    TestResult whole =
        new TestResult(
            "M",
            new Provenance("", 1, "", "", "", "", "", ""),
            Statistics.of(cases, true),
            List.of(),
            cases,
            null);
    assertThat(whole.summary().times().first()).isEqualTo(370.0);
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    TestResultXml.write(whole, out);
    String document = out.toString(StandardCharsets.UTF_8);
    assertThat(read(document)).isEqualTo(whole);
    for (String damage : List.of("calls=\"8\"", "calls=\"-1\"", "calls=\"7000000\"")) {
      assertThatThrownBy(() -> read(document.replace("calls=\"7\"", damage)))
          .as(damage)
          .isInstanceOf(InvalidInputException.class)
          .hasMessageContaining("repeated_calls must have");
    }
    assertThatThrownBy(() -> read(document.replace(">5.001 ", ">x ")))
        .hasMessageContaining("repeated_calls must have numbers as samples");
  }

  private static TestResult read(String document) {
    return TestResultXml.read(
        new ByteArrayInputStream(document.getBytes(StandardCharsets.UTF_8)), "result.xml");
  }

  @Test
  void junitCountsEqualTheSummary() {
    TestResult result = assembler.assemble(List.of(first()), "stopped", PROVENANCE);
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    JunitXml.write("activity", List.of(result), out);
    assertThat(out.toString(StandardCharsets.UTF_8))
        .contains("tests=\"3\" failures=\"0\" errors=\"0\" skipped=\"2\"")
        .contains("name=\"1: n=0\"")
        .contains("<skipped message=\"stopped\">")
        .containsOnlyOnce("<system-out>DONT in 2 cases (2, 3): stopped</system-out>");
  }

  @Test
  void aSuspectResultIsAnErrorInJunit() {
    TestResult result =
        assembler
            .assemble(List.of(first()), "stopped", PROVENANCE)
            .withSuspicions(List.of("a line without number and token (3 times)"));
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    TestResultXml.write(result, out);
    assertThat(TestResultXml.read(new ByteArrayInputStream(out.toByteArray()), "result.xml"))
        .isEqualTo(result);

    ByteArrayOutputStream report = new ByteArrayOutputStream();
    JunitXml.write("activity", List.of(result), report);
    assertThat(report.toString(StandardCharsets.UTF_8))
        .contains("tests=\"4\" failures=\"0\" errors=\"1\"")
        .contains("<error message=\"the result is suspect\">a line without number");
  }
}
