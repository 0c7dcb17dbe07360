package org.sitaf.core.verdict;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.document.TestModelXml;
import org.sitaf.core.suite.GenerationOptions;
import org.sitaf.core.suite.SecondRun;
import org.sitaf.core.suite.SecondRuns;
import org.sitaf.core.suite.TestCaseGenerator;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.trajectory.TrajectoryConditions;
import org.sitaf.core.verdict.CaseRecord.Outcome;
import org.sitaf.core.verdict.document.TestResultXml;

class RelationVerdictsTest {
  private static final String MODEL =
      """
      <test_model>
        <name>Turn</name>
        <pre_condition_spec_list><pre_condition>angle &lt; 100.0</pre_condition></pre_condition_spec_list>
        <input_spec_list>
          <test_element abstract_type="NUMERIC" real_type="double"><name>angle</name><type>TDI</type>
            <user_value_list><value>1.0</value><value>90.0</value></user_value_list></test_element>
        </input_spec_list>
        <output_spec_list>
          %s
        </output_spec_list>
        <relation_list>
          <relation name="further">
            <change name="angle">angle + 20.0</change>
            <holds><![CDATA[%s]]></holds>
          </relation>
        </relation_list>
        <order_of_combinations>1</order_of_combinations>
      </test_model>
      """;

  private static final String INCREASES = "after.value > before.value + angle * 0.0";

  private String holds = INCREASES;
  private String expected = "";

  /** Whether the model declares the return value. */
  private boolean declared = true;

  private TestModel model() {
    String output =
        """
        <test_element abstract_type="NUMERIC" real_type="double"><name>return</name><type>RETURN</type>%s</test_element>
        """
            .formatted(expected);
    String xml = MODEL.formatted(declared ? output : "", holds);
    return TestModelXml.read(
        new ByteArrayInputStream(xml.getBytes(StandardCharsets.UTF_8)), "Turn.xml");
  }

  private static CaseRecord returned(int no, String value) {
    return new CaseRecord(
        no,
        Outcome.RETURNED,
        "",
        List.of(new NamedValue("return", value)),
        StubCalls.NONE,
        new CaseResult.ProcessingTime(1, 0, 0),
        "");
  }

  private static CaseRecord threw(int no, String name) {
    return new CaseRecord(
        no, Outcome.THREW, name, List.of(), StubCalls.NONE, null, name + ": no echo");
  }

  private TestResult judged(CaseRecord first, List<CaseRecord> second, String reasonOfRest) {
    TestModel model = model();
    TestSuite suite = TestCaseGenerator.generate(model, GenerationOptions.DEFAULT).suite();
    SecondRun run = SecondRuns.of(model, suite, null).get(0);
    ResultAssembler assembler =
        new ResultAssembler(
            model,
            suite,
            List.of(),
            TrajectoryConditions.NONE,
            List.of(new ExecutedSecondRun(run, second, reasonOfRest)));
    List<CaseResult> results = new ArrayList<>();
    results.add(assembler.judge(first));
    results.add(assembler.judge(returned(2, "90.0")));
    return assembler.assemble(results, "", new Provenance("", 1, "", "", "", "", "", ""));
  }

  private CaseResult first(CaseRecord first, CaseRecord second) {
    return judged(first, List.of(second), "").cases().get(0);
  }

  @Test
  void aReturnValueThatTheModelDoesNotDeclareIsCompared() {
    declared = false;
    assertThat(first(returned(1, "1.0"), returned(1, "21.0")).verdict()).isEqualTo(Verdict.PASS);
    CaseResult broken = first(returned(1, "1.0"), returned(1, "0.5"));
    assertThat(broken.verdict()).isEqualTo(Verdict.FAIL);
    assertThat(broken.message()).contains("0.5 > 1.0");
  }

  @Test
  void aRelationThatHoldsPasses() {
    CaseResult result = first(returned(1, "1.0"), returned(1, "21.0"));
    assertThat(result.verdict()).isEqualTo(Verdict.PASS);
    assertThat(result.relations())
        .containsExactly(
            new RelationResult(
                "further",
                RelationResult.Outcome.PASS,
                List.of("21.0"),
                List.of(new NamedValue("", "21.0")),
                ""));
  }

  @Test
  void aBrokenRelationFailsAndNamesBothRuns() {
    CaseResult result = first(returned(1, "1.0"), returned(1, "0.5"));
    assertThat(result.verdict()).isEqualTo(Verdict.FAIL);
    assertThat(result.message())
        .contains("relation 'further' is broken: 0.5 > 1.0;")
        .contains("first run: angle=1.0 gave 1.0; second run: angle=21.0 gave 0.5");
  }

  @Test
  void countsTheCasesOfEachRelation() {
    TestResult result = judged(returned(1, "1.0"), List.of(returned(1, "0.5")), "");
    // The second case is beyond the pre-condition.
    assertThat(RelationCount.of(result.cases()))
        .containsExactly(new RelationCount("further", 1, 1, 1, 0));
    assertThat(result.cases().get(1).verdict()).isEqualTo(Verdict.PASS);
    assertThat(result.cases().get(1).relations().get(0).outcome())
        .isEqualTo(RelationResult.Outcome.SKIPPED);
    assertThat(result.summary().total()).isEqualTo(2);
    // Nothing judges the second case.
    assertThat(result.summary().unjudged()).isEqualTo(1);
  }

  @Test
  void anUnexpectedExceptionInEitherRunIsAnError() {
    CaseResult second = first(returned(1, "1.0"), threw(1, "NoEcho"));
    assertThat(second.verdict()).isEqualTo(Verdict.ERROR);
    assertThat(second.message())
        .contains("the second run failed: NoEcho: no echo")
        .contains("first run: angle=1.0; second run: angle=21.0");
    CaseResult before = first(threw(1, "NoEcho"), returned(1, "1.0"));
    assertThat(before.verdict()).isEqualTo(Verdict.ERROR);
    assertThat(before.message()).isEqualTo("NoEcho: no echo");
    assertThat(before.relations().get(0).outcome()).isEqualTo(RelationResult.Outcome.ERROR);
  }

  @Test
  void anExpectedExceptionIsComparedByItsName() {
    expected = "<expected>angle &lt; 10.0 ? \"!any\" : \"!error:TooFar\"</expected>";
    holds = "after.error == \"TooFar\" && before.error == \"\"";
    assertThat(first(returned(1, "1.0"), threw(1, "TooFar")).verdict()).isEqualTo(Verdict.PASS);
    assertThat(first(returned(1, "1.0"), threw(1, "NoEcho")).verdict()).isEqualTo(Verdict.ERROR);
    holds = INCREASES;
    CaseResult valueless = first(returned(1, "1.0"), threw(1, "TooFar"));
    assertThat(valueless.verdict()).isEqualTo(Verdict.ERROR);
    assertThat(valueless.message()).contains("relation 'further' cannot be checked: after.value");
  }

  @Test
  void aCrashOrAMissingSecondRunIsAnError() {
    assertThat(first(returned(1, "1.0"), CaseRecord.error(1, "killed by signal 11")).message())
        .contains("the second run failed: killed by signal 11");
    CaseResult missing =
        judged(returned(1, "1.0"), List.of(), "20 processes crashed").cases().get(0);
    assertThat(missing.verdict()).isEqualTo(Verdict.ERROR);
    assertThat(missing.message()).contains("the second run was not executed: 20 processes crashed");
  }

  @Test
  void aWrongValueAndABrokenRelationAreBothReported() {
    expected = "<expected>angle</expected>";
    CaseResult result = first(returned(1, "2.0"), returned(1, "0.5"));
    assertThat(result.verdict()).isEqualTo(Verdict.FAIL);
    assertThat(result.message())
        .contains("expected 1.0, but was 2.0")
        .contains("relation 'further' is broken");
  }

  @Test
  void aResultIsReadAsItWasWritten() {
    for (CaseRecord second : List.of(returned(1, "21.0"), returned(1, "0.5"), threw(1, "NoEcho"))) {
      TestResult result = judged(returned(1, "1.0"), List.of(second), "");
      ByteArrayOutputStream out = new ByteArrayOutputStream();
      TestResultXml.write(result, out);
      assertThat(TestResultXml.read(new ByteArrayInputStream(out.toByteArray()), "r.xml"))
          .isEqualTo(result);
    }
  }
}
