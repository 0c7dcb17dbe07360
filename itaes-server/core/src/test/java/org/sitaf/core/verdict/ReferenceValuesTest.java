package org.sitaf.core.verdict;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.document.TestModelXml;
import org.sitaf.core.suite.ExpectedValue;
import org.sitaf.core.suite.GenerationOptions;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestCaseGenerator;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.verdict.CaseRecord.Outcome;

class ReferenceValuesTest {
  private static final String MODEL =
      """
      <test_model>
        <name>Move</name>
        <input_spec_list>
          <test_element abstract_type="NUMERIC" real_type="int">
            <name>a</name><type>TDI</type>
            <user_value_list><value>1</value></user_value_list>
          </test_element>
        </input_spec_list>
        <output_spec_list>
          <test_element abstract_type="NUMERIC" real_type="double">
            <name>return</name><type>RETURN</type>
            <tolerance absolute="0.5" relative="0"/>
          </test_element>
          <test_element abstract_type="NUMERIC" real_type="int">
            <name>count</name><type>OUT</type><expected>3</expected>
          </test_element>
        </output_spec_list>
        <order_of_combinations>1</order_of_combinations>
      </test_model>
      """;

  private final TestModel model =
      TestModelXml.read(
          new ByteArrayInputStream(MODEL.getBytes(StandardCharsets.UTF_8)), "Move.xml");
  private final TestSuite suite =
      TestCaseGenerator.generate(model, GenerationOptions.DEFAULT).suite();

  private static CaseRecord record(Outcome outcome, String thrown, String message, String value) {
    List<NamedValue> actual =
        outcome == Outcome.RETURNED
            ? List.of(new NamedValue("return", value), new NamedValue("count", "3"))
            : List.of();
    return new CaseRecord(1, outcome, thrown, actual, StubCalls.NONE, null, message);
  }

  private CaseResult judged(CaseRecord ofReference, CaseRecord ofComponent) {
    TestSuite with = ReferenceValues.added(model, suite, List.of(ofReference));
    return new ResultAssembler(model, with).judge(ofComponent);
  }

  @Test
  void addsTheValuesOfOutputsWithoutAnExpectedValue() {
    TestSuite with =
        ReferenceValues.added(model, suite, List.of(record(Outcome.RETURNED, "", "", "2.5")));
    assertThat(with.cases().get(0).expected())
        .containsExactlyInAnyOrder(
            new ExpectedValue("return", "2.5"), new ExpectedValue("count", "3"));
  }

  @Test
  void comparesWithinTheTolerance() {
    CaseRecord reference = record(Outcome.RETURNED, "", "", "2.5");
    assertThat(judged(reference, record(Outcome.RETURNED, "", "", "2.9")).verdict())
        .isEqualTo(Verdict.PASS);
    CaseResult wrong = judged(reference, record(Outcome.RETURNED, "", "", "3.5"));
    assertThat(wrong.verdict()).isEqualTo(Verdict.FAIL);
    assertThat(wrong.message()).contains("return: expected 2.5, but was 3.5");
  }

  @Test
  void expectsTheExceptionOfTheReference() {
    CaseRecord reference = record(Outcome.THREW, "TooFar", "TooFar: 9 m", "");
    assertThat(judged(reference, reference).verdict()).isEqualTo(Verdict.PASS);
    CaseResult wrong = judged(reference, record(Outcome.RETURNED, "", "", "3.5"));
    assertThat(wrong.verdict()).isEqualTo(Verdict.FAIL);
    assertThat(wrong.message()).contains("expected the error TooFar, but it returned 3.5");
  }

  @Test
  void aFailedReferenceJudgesNothing() {
    CaseRecord component = record(Outcome.RETURNED, "", "", "3.5");
    CaseResult crashed = judged(CaseRecord.error(1, "signal 11 (SIGSEGV)"), component);
    assertThat(crashed.verdict()).isEqualTo(Verdict.ERROR);
    assertThat(crashed.message()).contains("the reference failed: signal 11 (SIGSEGV)");
    TestSuite without = ReferenceValues.added(model, suite, List.of());
    assertThat(new ResultAssembler(model, without).judge(component).message())
        .contains("the reference did not execute it");
  }

  private static final String SEQUENCE =
      """
      <test_model>
        <name>Counting</name>
        <input_spec_list/>
        <sequence_spec length="3" order="1">
          <state name="on" type="boolean" initial="false"/>
          <call name="On"><update state="on">true</update></call>
          <call name="Count">
            <guard>on</guard>
            <forbidden>!error:Off</forbidden>
            <output_spec_list>
              <test_element abstract_type="NUMERIC" real_type="int"><name>return</name><type>RETURN</type></test_element>
            </output_spec_list>
          </call>
        </sequence_spec>
        <order_of_combinations>1</order_of_combinations>
      </test_model>
      """;

  private static CaseRecord steps(TestCase of, int count) {
    List<StepRecord> steps = new ArrayList<>();
    for (int i = 0; i < of.steps().size(); i++) {
      String name = of.steps().get(i).name();
      boolean isForbidden = !of.steps().get(i).valid();
      steps.add(
          new StepRecord(
              i + 1,
              name,
              0,
              new CaseRecord(
                  of.no(),
                  isForbidden ? Outcome.THREW : Outcome.RETURNED,
                  isForbidden ? "Off" : "",
                  name.equals("Count") && !isForbidden
                      ? List.of(new NamedValue("return", Integer.toString(count)))
                      : List.of(),
                  StubCalls.NONE,
                  null,
                  "")));
    }
    return new CaseRecord(of.no(), Outcome.RETURNED, "", List.of(), StubCalls.NONE, null, "")
        .with(steps);
  }

  @Test
  void eachStepOfASequenceExpectsWhatTheReferenceGaveThere() {
    TestModel sequence =
        TestModelXml.read(
            new ByteArrayInputStream(SEQUENCE.getBytes(StandardCharsets.UTF_8)), "Counting.xml");
    TestSuite planned = TestCaseGenerator.generate(sequence, GenerationOptions.DEFAULT).suite();
    List<CaseRecord> ofReference = planned.cases().stream().map(c -> steps(c, 7)).toList();
    TestSuite with = ReferenceValues.added(sequence, planned, ofReference);
    ResultAssembler judge = new ResultAssembler(sequence, with);

    assertThat(with.cases()).anyMatch(c -> c.steps().stream().anyMatch(s -> !s.valid()));
    for (TestCase testCase : with.cases()) {
      assertThat(judge.judge(steps(testCase, 7)).verdict()).isEqualTo(Verdict.PASS);
      CaseResult wrong = judge.judge(steps(testCase, 8));
      boolean counts =
          testCase.steps().stream().anyMatch(s -> s.name().equals("Count") && s.valid());
      assertThat(wrong.verdict()).isEqualTo(counts ? Verdict.FAIL : Verdict.PASS);
      assertThat(wrong.message().contains("(Count): expected 7, but was 8")).isEqualTo(counts);
    }
  }
}
