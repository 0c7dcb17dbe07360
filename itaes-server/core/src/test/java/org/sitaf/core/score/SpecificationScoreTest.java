package org.sitaf.core.score;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import org.junit.jupiter.api.Test;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.document.TestModelXml;
import org.sitaf.core.score.SpecificationScore.Survivor;
import org.sitaf.core.suite.GenerationOptions;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestCaseGenerator;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.trajectory.TrajectoryConditions;
import org.sitaf.core.verdict.CaseRecord;
import org.sitaf.core.verdict.CaseRecord.Outcome;
import org.sitaf.core.verdict.NamedValue;
import org.sitaf.core.verdict.StubCalls;
import org.sitaf.core.verdict.Verdict;

class SpecificationScoreTest {
  private static final String EXPECTED =
      "<expected>valid &amp;&amp; A &lt;= B ? X : -1.0</expected>";
  private static final int BUDGET = 2_000;

  private static TestModel model(String output, String conditions) {
    String range =
        "<test_element abstract_type='NUMERIC' real_type='%s'><name>%s</name><type>TDI</type>"
            + "<test_spec type='BVA' offset='%s'><equiv_class type='NEC_NUMERIC_TWO_BOUNDARY'"
            + " min='%s' max='%s'/></test_spec></test_element>";
    return read(
        range.formatted("int", "A", "1", "1", "7")
            + range.formatted("int", "B", "1", "1", "7")
            + range.formatted("double", "X", "0.5", "0", "10"),
        output,
        conditions);
  }

  private static TestModel read(String inputs, String output, String conditions) {
    String document =
        "<test_model><name>M</name><target interface='I' method='m'/><input_spec_list>"
            + inputs
            + "</input_spec_list><output_spec_list><test_element abstract_type='NUMERIC'"
            + " real_type='double'><name>return</name><type>RETURN</type>"
            + output
            + "</test_element></output_spec_list>"
            + conditions
            + "<order_of_combinations>2</order_of_combinations></test_model>";
    return TestModelXml.read(new ByteArrayInputStream(document.getBytes(UTF_8)), "M.xml");
  }

  /** The sensor of the paper: -1 outside of its ranges. */
  private static double sensor(double[] v) {
    boolean valid = v[0] >= 1 && v[0] <= v[1] && v[1] <= 7 && v[2] >= 0 && v[2] <= 10;
    return valid ? v[2] : -1;
  }

  private static CaseRecord returned(TestCase testCase, double value) {
    return new CaseRecord(
        testCase.no(),
        Outcome.RETURNED,
        "",
        List.of(new NamedValue("return", Double.toString(value))),
        StubCalls.NONE,
        null,
        "");
  }

  private static FaultJudge judge(TestModel model, Function<TestCase, CaseRecord> component) {
    TestSuite suite = TestCaseGenerator.generate(model, GenerationOptions.DEFAULT).suite();
    FaultExecutions executions = new FaultExecutions(model, suite, null, List.of(), BUDGET);
    Map<Integer, CaseRecord> records = new HashMap<>();
    executions.cases().cases().forEach(c -> records.put(c.no(), component.apply(c)));
    return new FaultJudge(
        executions, suite, List.of(), TrajectoryConditions.NONE, records, Map.of());
  }

  private static SpecificationScore score(TestModel model) {
    FaultJudge judge =
        judge(
            model,
            c ->
                returned(
                    c, sensor(c.values().stream().mapToDouble(Double::parseDouble).toArray())));
    assertThat(judge.baseline().values()).allMatch(r -> r.verdict() == Verdict.PASS);
    return judge.score();
  }

  @Test
  void aWholeSpecificationNoticesAllFaults() {
    SpecificationScore score = score(model(EXPECTED, ""));

    assertThat(score.injected()).isGreaterThanOrEqualTo(200);
    assertThat(score.survivors()).isEmpty();
    assertThat(score.noticed() + score.equivalent()).isEqualTo(score.injected());
    assertThat(score.byOutput()).containsOnlyKeys("return");
    assertThat(score.warnings()).isEmpty();
  }

  @Test
  void aWideToleranceIsNamedWithItsFigure() {
    SpecificationScore score = score(model(EXPECTED + "<tolerance absolute='0.25'/>", ""));

    assertThat(score.survivors())
        .filteredOn(s -> s.fault().equals("return: 0.001 too large"))
        .singleElement()
        .satisfies(
            s ->
                assertThat(s.suggestion())
                    .contains("the tolerance of return (absolute 0.25", "narrow the tolerance"));
    assertThat(score.survivors()).noneMatch(s -> s.fault().equals("return: 1.0 too large"));
  }

  @Test
  void aToleranceBeyondTheRangeIsAWarning() {
    assertThat(score(model(EXPECTED + "<tolerance absolute='20'/>", "")).warnings())
        .anyMatch(w -> w.contains("the tolerance of return, 20.0, is wider than the range"));
  }

  @Test
  void withoutAnExpectedValueOnlyExceptionsAreNoticed() {
    SpecificationScore score = score(model("", ""));

    assertThat(score.warnings()).contains("nothing is expected of return");
    assertThat(score.share()).isLessThan(0.3);
    assertThat(score.survivors())
        .filteredOn(s -> s.fault().equals("return: sign inverted"))
        .singleElement()
        .satisfies(
            s -> assertThat(s.suggestion()).startsWith("add an expected value of return: case "));
  }

  @Test
  void aPostConditionCounts() {
    String condition =
        "<post_condition_spec_list><post_condition>actual &gt;= -1.0</post_condition>"
            + "</post_condition_spec_list>";
    assertThat(score(model("", condition)).share())
        .isGreaterThan(score(model("", "")).share())
        .isLessThan(score(model(EXPECTED, "")).share());
  }

  @Test
  void valuesThatTheSuiteDoesNotReachAreSuggested() {
    String values =
        "<test_element abstract_type='NUMERIC' real_type='int'><name>%s</name><type>TDI</type>"
            + "<user_value_list><value>3</value></user_value_list></test_element>";
    String real =
        "<test_element abstract_type='NUMERIC' real_type='double'><name>X</name><type>TDI</type>"
            + "<user_value_list><value>5.0</value></user_value_list></test_element>";
    SpecificationScore score =
        score(read(values.formatted("A") + values.formatted("B") + real, EXPECTED, ""));

    assertThat(score.survivors())
        .filteredOn(s -> s.fault().equals("return: wrong value where A is 4"))
        .singleElement()
        .extracting(Survivor::suggestion)
        .isEqualTo("no case reaches it: add the value 4 of A");
    assertThat(score.share()).isLessThan(score(model(EXPECTED, "")).share());
  }

  @Test
  void anInputWithoutInfluenceIsAWarning() {
    FaultJudge judge = judge(model("<expected>1.0</expected>", ""), c -> returned(c, 1));

    assertThat(judge.score().warnings())
        .contains("no recorded value depends on A", "no recorded value depends on X");
  }

  @Test
  void aSwallowedExceptionIsNoticedOnlyWhereAnErrorIsExpected() {
    Function<TestCase, CaseRecord> component =
        c ->
            Integer.parseInt(c.values().get(0)) > 7
                ? new CaseRecord(
                    c.no(), Outcome.THREW, "Range", List.of(), StubCalls.NONE, null, "Range: 8")
                : returned(c, 1);
    SpecificationScore strict =
        judge(model("<expected>A &gt; 7 ? '!error:Range' : 1.0</expected>", ""), component).score();
    SpecificationScore loose =
        judge(model("<expected>A &gt; 7 ? '!any' : 1.0</expected>", ""), component).score();
    String swallowed = "exception: swallowed, the outputs are never set";

    assertThat(strict.survivors()).noneMatch(s -> s.fault().equals(swallowed));
    assertThat(loose.survivors())
        .filteredOn(s -> s.fault().equals(swallowed))
        .singleElement()
        .satisfies(s -> assertThat(s.suggestion()).startsWith("expect !error:Range in case"));
  }

  @Test
  void casesThatFailWithoutFaultsNoticeNothing() {
    SpecificationScore score = judge(model(EXPECTED, ""), c -> returned(c, 100)).score();

    assertThat(score.noticed()).isZero();
    assertThat(score.warnings()).anyMatch(w -> w.contains("do not pass without faults"));
  }

  @Test
  void eachExecutedCaseIsDifferent() {
    TestModel model = model(EXPECTED, "");
    TestSuite suite = TestCaseGenerator.generate(model, GenerationOptions.DEFAULT).suite();
    FaultExecutions executions = new FaultExecutions(model, suite, null, List.of(), 100);

    List<TestCase> cases = executions.cases().cases();
    assertThat(cases).extracting(TestCase::values).doesNotHaveDuplicates();
    assertThat(cases.subList(0, suite.cases().size())).isEqualTo(suite.cases());
    assertThat(executions.further()).isEqualTo(100);
  }
}
