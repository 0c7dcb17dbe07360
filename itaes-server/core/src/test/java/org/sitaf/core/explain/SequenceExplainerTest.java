package org.sitaf.core.explain;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.sitaf.core.explain.Explanation.Cause;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.document.TestModelXml;
import org.sitaf.core.suite.GenerationOptions;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestCaseGenerator;
import org.sitaf.core.suite.TestStep;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.StepResult;
import org.sitaf.core.verdict.StepResult.Kind;
import org.sitaf.core.verdict.Verdict;

class SequenceExplainerTest {
  private static final String MODEL =
      """
      <test_model><name>Door</name><target interface="Door"/><input_spec_list/>
        <sequence_spec length="8" order="3">
          <state name="open" type="boolean" initial="false"/>
          <call name="Open"><update state="open">true</update></call>
          <call name="Close"><update state="open">false</update></call>
          <call name="Look"><guard>open</guard>
            <output_spec_list><test_element abstract_type="NUMERIC" real_type="int">
              <name>return</name><type>RETURN</type><expected>step</expected></test_element></output_spec_list>
          </call>
          <call name="Wait"/>
        </sequence_spec>
        <order_of_combinations>1</order_of_combinations>
      </test_model>
      """;

  private final TestModel model =
      TestModelXml.read(
          new ByteArrayInputStream(MODEL.getBytes(StandardCharsets.UTF_8)), "Door.xml");
  private final TestSuite suite =
      TestCaseGenerator.generate(model, GenerationOptions.DEFAULT).suite();
  private final List<TestCase> executed = new ArrayList<>();
  private boolean reproducible = true;

  /** The fault: a second look fails after a wait since the first one. */
  private static CaseResult run(TestCase testCase) {
    List<StepResult> steps = new ArrayList<>();
    String names = "";
    Verdict verdict = Verdict.PASS;
    String message = "";
    for (TestStep step : testCase.steps()) {
      names += step.name() + " ";
      boolean wrong = names.matches(".*Look .*Wait .*Look $");
      Verdict own = wrong ? Verdict.FAIL : Verdict.PASS;
      StepResult result =
          new StepResult(
              step.name(),
              Kind.VALID,
              own,
              verdict != Verdict.PASS,
              List.of(),
              List.of(),
              List.of(),
              0.0,
              null,
              wrong ? "expected 1, but was 2" : "",
              null,
              null);
      steps.add(result);
      if (result.decides()) {
        verdict = own;
        message = result.label(steps.size()) + ": " + result.message();
      }
    }
    return new CaseResult(
            testCase.no(), verdict, testCase.values(), List.of(), List.of(), null, message)
        .withSteps(steps);
  }

  private Explanation explain(int budget) throws InterruptedException {
    return new SequenceExplainer(
            model,
            suite,
            suite.cases().stream().map(SequenceExplainerTest::run).toList(),
            null,
            cases -> {
              executed.addAll(cases);
              return cases.stream()
                  .map(
                      c ->
                          reproducible
                              ? run(c)
                              : run(new TestCase(c.no(), true, c.values(), List.of())))
                  .toList();
            },
            budget)
        .explain();
  }

  @Test
  void a_failure_is_shortened_to_the_steps_that_it_takes() throws InterruptedException {
    Explanation explanation = explain(500);
    assertThat(explanation.unexplained()).isEmpty();
    assertThat(explanation.causes()).hasSize(1);
    Cause cause = explanation.causes().get(0);
    assertThat(cause.steps()).containsExactly("Open()", "Look()", "Wait()", "Look()");
    assertThat(cause.message()).isEqualTo("step 4 (Look): expected 1, but was 2");
    assertThat(cause.cases()).isNotEmpty();
    assertThat(explanation.executions()).isEqualTo(executed.size()).isLessThan(60);
  }

  @Test
  void only_allowed_sequences_are_executed_with_the_expected_values_that_they_have_there()
      throws InterruptedException {
    explain(500);
    for (TestCase testCase : executed) {
      String names = testCase.steps().stream().map(TestStep::name).collect(Collectors.joining(" "));
      assertThat(names)
          .doesNotMatch("^(Wait |Close )*Look.*")
          .doesNotMatch(".*Close (Wait )*Look.*");
      for (int i = 0; i < testCase.steps().size(); i++) {
        if (testCase.steps().get(i).name().equals("Look")) {
          assertThat(testCase.steps().get(i).expected().get(0).literal())
              .isEqualTo(Integer.toString(i + 1));
        }
      }
    }
  }

  @Test
  void the_budget_is_kept() throws InterruptedException {
    assertThat(explain(3).executions()).isLessThanOrEqualTo(3);
    assertThat(explain(0).unexplained()).isNotEmpty();
  }

  @Test
  void a_failure_that_does_not_happen_again_is_not_explained() throws InterruptedException {
    reproducible = false;
    assertThat(explain(500).causes()).isEmpty();
    assertThat(explain(500).unexplained()).isNotEmpty();
  }
}
