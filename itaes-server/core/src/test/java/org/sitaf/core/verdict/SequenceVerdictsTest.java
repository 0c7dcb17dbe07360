package org.sitaf.core.verdict;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.document.TestModelXml;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.suite.document.TestSuiteXml;
import org.sitaf.core.verdict.CaseRecord.Outcome;
import org.sitaf.core.verdict.document.CaseRecordLine;
import org.sitaf.core.verdict.document.TestResultXml;

class SequenceVerdictsTest {
  private static final String MODEL =
      """
      <test_model>
        <name>Counter</name>
        <target interface="Counter"/>
        <input_spec_list/>
        <sequence_spec length="4" order="1">
          <state name="count" type="int" initial="0"/>
          <call name="Add">
            <update state="count">count + by</update>
            <input_spec_list>
              <test_element abstract_type="NUMERIC" real_type="int"><name>by</name><type>TDI</type>
                <user_value_list><value>1</value><value>2</value></user_value_list></test_element>
            </input_spec_list>
          </call>
          <call name="Get">
            <output_spec_list>
              <test_element abstract_type="NUMERIC" real_type="int"><name>return</name><type>RETURN</type></test_element>
            </output_spec_list>
            <post_condition_spec_list>
              <post_condition name="counts">actual == count</post_condition>
              <post_condition name="has a number">step >= 1</post_condition>
            </post_condition_spec_list>
          </call>
          <event name="Night" set="Light" to="0"/>
        </sequence_spec>
        <post_condition_spec_list>
          <post_condition name="never above 3">%s</post_condition>
        </post_condition_spec_list>
        <order_of_combinations>1</order_of_combinations>
      </test_model>
      """;

  private static final String SUITE =
      """
      <test_suite_data><name>Counter</name><description/><test_model_name>Counter</test_model_name>
        <generation order_of_combinations="1" invalid_values="isolate" seed="1" effort="default" generator="g"/>
        <case_param_info/>
        <step_param_info>
          <step name="Add"><param name="by" type="TDI" real_type="int"/></step><step name="Get"/><step name="Night"/>
        </step_param_info>
        <case_list><case no="1" class="valid">
          <step name="Add"><value>2</value></step><step name="Night"/><step name="Add"><value>1</value></step>
          <step name="Get"><expected>3</expected></step>
        </case></case_list>
      </test_suite_data>
      """;

  private static final String ALL =
      "steps.all(s, s.name != \"Get\" || s.outputs.value <= 3 && s.error == \"\" && s.time >= 0.0)";

  private String condition = ALL;
  private String cases = SUITE;

  private static byte[] utf8(String text) {
    return text.getBytes(StandardCharsets.UTF_8);
  }

  private TestModel model() {
    String xml = MODEL.formatted(condition.replace("&", "&amp;").replace("<", "&lt;"));
    return TestModelXml.read(new ByteArrayInputStream(utf8(xml)), "Counter.xml");
  }

  private CaseResult judge(CaseRecord record) {
    TestSuite suite = TestSuiteXml.read(new ByteArrayInputStream(utf8(cases)), "suite.xml");
    CaseResult result = new ResultAssembler(model(), suite).judge(record);
    assertThat(reread(result, suite)).isEqualTo(result);
    return result;
  }

  /** The result after it was written to a document and read again. */
  private CaseResult reread(CaseResult result, TestSuite suite) {
    TestResult whole =
        new ResultAssembler(model(), suite)
            .assemble(List.of(result), "", new Provenance("", 1, "", "", "", "", "", ""));
    ByteArrayOutputStream xml = new ByteArrayOutputStream();
    TestResultXml.write(whole, xml);
    return TestResultXml.read(new ByteArrayInputStream(xml.toByteArray()), "r.xml").cases().get(0);
  }

  private static StepRecord step(int number, String name, String content) {
    return CaseRecordLine.readStep(
        "<step_record no=\"1\" step=\""
            + number
            + "\" name=\""
            + name
            + "\" outcome=\""
            + (content.startsWith("<thrown>") ? "THREW" : "RETURNED")
            + "\" at_ns=\""
            + 100_000_000L * number
            + "\">"
            + content
            + "</step_record>");
  }

  private static CaseRecord ended(StepRecord... steps) {
    return new CaseRecord(1, Outcome.RETURNED, "", List.of(), StubCalls.NONE, null, "")
        .with(List.of(steps));
  }

  private static CaseRecord withValue(String value) {
    return ended(
        step(1, "Add", ""),
        step(2, "Night", ""),
        step(3, "Add", ""),
        step(4, "Get", "<actual name=\"return\">" + value + "</actual>"));
  }

  private static List<Verdict> verdicts(CaseResult result) {
    return result.steps().stream().map(StepResult::verdict).toList();
  }

  @Test
  void a_sequence_passes_when_each_step_and_the_conditions_over_all_steps_hold() {
    CaseResult result = judge(withValue("3"));
    assertThat(result.verdict()).as(result.message()).isEqualTo(Verdict.PASS);
    assertThat(verdicts(result)).containsOnly(Verdict.PASS).hasSize(4);
    assertThat(result.steps().get(3).at()).isEqualTo(0.4);
  }

  @Test
  void the_first_failed_step_decides_and_later_ones_are_marked() {
    CaseResult result =
        judge(
            ended(
                step(1, "Add", "<thrown>Full</thrown><message>Full: no room</message>"),
                step(2, "Night", ""),
                step(3, "Add", ""),
                step(4, "Get", "<actual name=\"return\">1</actual>")));
    assertThat(result.verdict()).isEqualTo(Verdict.ERROR);
    assertThat(result.message()).isEqualTo("step 1 (Add): Full: no room");
    assertThat(verdicts(result))
        .containsExactly(Verdict.ERROR, Verdict.PASS, Verdict.PASS, Verdict.FAIL);
    assertThat(result.steps().stream().map(StepResult::afterFailure))
        .containsExactly(false, true, true, true);
    // The call that threw has not changed the abstract state.
    assertThat(result.steps().get(3).message())
        .contains("expected 3, but was 1")
        .doesNotContain("counts");
  }

  @Test
  void a_wrong_value_names_its_step_and_the_state_before_it() {
    CaseResult result = judge(withValue("4"));
    assertThat(result.verdict()).isEqualTo(Verdict.FAIL);
    assertThat(result.message())
        .startsWith("step 4 (Get): expected 3, but was 4")
        .contains("post-condition violated: counts: 4 == 3")
        .contains("post-condition violated: never above 3");
  }

  @Test
  void a_condition_over_all_steps_fails_the_case_but_no_step() {
    condition = "steps[0].inputs.by + steps[2].inputs.by == 4";
    CaseResult result = judge(withValue("3"));
    assertThat(result.verdict()).isEqualTo(Verdict.FAIL);
    assertThat(result.message()).isEqualTo("post-condition violated: never above 3: 3 == 4");
    assertThat(verdicts(result)).containsOnly(Verdict.PASS);
  }

  @Test
  void a_component_that_dies_is_an_error_of_its_step_and_the_rest_is_not_executed() {
    CaseRecord died =
        CaseRecord.error(1, "the test application ended with signal 11")
            .with(
                List.of(
                    step(1, "Add", ""),
                    StepRecord.error(1, 2, "Night", "the test application ended with signal 11")));
    CaseResult result = judge(died);
    assertThat(result.verdict()).isEqualTo(Verdict.ERROR);
    assertThat(result.message())
        .isEqualTo("step 2 (Night): the test application ended with signal 11");
    assertThat(verdicts(result))
        .containsExactly(Verdict.PASS, Verdict.ERROR, Verdict.DONT, Verdict.DONT);
    assertThat(result.steps().get(3).message())
        .isEqualTo("not executed: the sequence ended at step 2 (Night)");
  }

  @Test
  void steps_without_a_record_never_pass() {
    CaseResult result = judge(ended(step(1, "Add", "")));
    assertThat(verdicts(result))
        .isEqualTo(Arrays.asList(Verdict.PASS, Verdict.DONT, Verdict.DONT, Verdict.DONT));
    assertThat(result.verdict()).isEqualTo(Verdict.DONT);
  }

  @Test
  void an_exception_in_the_constructor_is_no_error_of_the_first_step() {
    CaseResult result = judge(CaseRecord.error(1, "ValueError: no such port"));
    assertThat(result.verdict()).isEqualTo(Verdict.ERROR);
    assertThat(result.message()).isEqualTo("before the first step: ValueError: no such port");
    assertThat(verdicts(result)).containsOnly(Verdict.DONT);
    assertThat(result.steps().get(0).message())
        .isEqualTo("not executed: the case failed before its first step");
  }

  @Test
  void steps_have_named_inputs_and_the_abstract_states_around_them() {
    CaseResult result = judge(withValue("3"));
    assertThat(result.steps().get(0).inputs()).containsExactly(new NamedValue("by", "2"));
    assertThat(result.steps().get(0).before()).isEqualTo("count=0");
    assertThat(result.steps().get(2).after()).isEqualTo("count=3");
    assertThat(result.steps().get(3).before()).isEqualTo("count=3");
  }

  @Test
  void a_call_without_outputs_that_should_have_thrown_fails() {
    condition = "true";
    cases =
        SUITE
            .replace("class=\"valid\"", "class=\"invalid\"")
            .replace(
                "<step name=\"Add\"><value>1</value></step>",
                "<step name=\"Add\" class=\"invalid\"><value>1</value>"
                    + "<expected>!error:Full</expected></step>");
    CaseResult result = judge(withValue("3"));
    assertThat(result.verdict()).isEqualTo(Verdict.FAIL);
    assertThat(result.message())
        .isEqualTo("step 3 (Add, invalid value): expected the error Full, but it returned");
  }

  @Test
  void a_diagram_has_the_executed_steps_and_those_that_are_allowed() {
    StateDiagram diagram =
        StateDiagram.of(model(), List.of(judge(withValue("4"))), 1).orElseThrow();
    assertThat(diagram.states().get(0)).isEqualTo(new StateDiagram.State("count=0", 1));
    assertThat(diagram.isComplete()).isTrue();
    assertThat(diagram.transitions().get(0).step()).isEqualTo("Get");
    assertThat(diagram.transitions().get(0).failed()).isEqualTo(1);
    assertThat(diagram.transitions().get(0).failedCase()).isEqualTo(1);
    // From 0: Add by 2, Add by 1, Night, Get; only the first one was executed there.
    assertThat(
            diagram.transitions().stream()
                .filter(t -> t.from() == 0)
                .map(t -> t.step() + " " + t.isCovered()))
        .containsExactlyInAnyOrder("Add true", "Add false", "Night false", "Get false");
  }

  @Test
  void the_plan_of_a_model_shows_what_is_allowed_and_what_is_forbidden() {
    String guarded =
        MODEL
            .formatted("true")
            .replace(
                "<call name=\"Get\">",
                "<call name=\"Get\"><guard>count &gt; 0</guard><forbidden>!error</forbidden>")
            .replace("length=\"4\"", "length=\"2\"");
    StateDiagram plan =
        StateDiagram.planned(
                TestModelXml.read(
                    new ByteArrayInputStream(guarded.getBytes(StandardCharsets.UTF_8)), "model"),
                1)
            .orElseThrow();
    assertThat(plan.states())
        .extracting(StateDiagram.State::name)
        .containsExactly("count=0", "count=1", "count=2", "count=3", "count=4");
    assertThat(plan.transitions().stream().noneMatch(StateDiagram.Transition::isCovered)).isTrue();
    assertThat(
            plan.transitions().stream()
                .filter(t -> t.from() == 0)
                .map(t -> t.step() + " " + t.kind() + " " + t.to()))
        .containsExactlyInAnyOrder(
            "Add VALID 1", "Add VALID 2", "Get FORBIDDEN 0", "Night VALID 0");
    assertThat(plan.transitions().stream().filter(t -> t.from() == 1 && t.step().equals("Get")))
        .extracting(StateDiagram.Transition::kind)
        .containsExactly(StepResult.Kind.VALID);
  }

  @Test
  void a_model_with_errors_has_no_plan() {
    String wrong = MODEL.formatted("true").replace("count + by", "count + nothing");
    assertThat(
            StateDiagram.planned(
                TestModelXml.read(
                    new ByteArrayInputStream(wrong.getBytes(StandardCharsets.UTF_8)), "model"),
                1))
        .isEmpty();
  }

  @Test
  void a_failure_before_the_first_step_is_the_case_s_own() {
    CaseRecord refused =
        new CaseRecord(
            1, Outcome.NOT_CALLED, "", List.of(), StubCalls.NONE, null, "Distance: too far");
    CaseResult result = judge(refused);
    assertThat(result.verdict()).isEqualTo(Verdict.DONT);
    assertThat(verdicts(result)).containsOnly(Verdict.DONT);
    assertThat(result.steps().get(0).message()).isEqualTo("Distance: too far");
  }
}
