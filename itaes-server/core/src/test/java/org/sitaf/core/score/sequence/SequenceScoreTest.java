package org.sitaf.core.score.sequence;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.document.TestModelXml;
import org.sitaf.core.score.SpecificationScore;
import org.sitaf.core.score.SpecificationScore.Survivor;
import org.sitaf.core.suite.GenerationOptions;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestCaseGenerator;
import org.sitaf.core.suite.TestStep;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.trajectory.TrajectoryConditions;
import org.sitaf.core.verdict.CaseRecord;
import org.sitaf.core.verdict.CaseRecord.Outcome;
import org.sitaf.core.verdict.NamedValue;
import org.sitaf.core.verdict.StepRecord;
import org.sitaf.core.verdict.StubCalls;
import org.sitaf.core.verdict.Verdict;

class SequenceScoreTest {
  private static final String WHOLE = "<expected>count</expected>";
  private static final String FORBIDDEN = "<forbidden>!error:Empty</forbidden>";
  private static final int BUDGET = 3_000;

  /** A counter: Add raises it by A, Take lowers it by one, Look returns it. */
  private static TestModel model(String expected, String forbidden, int length, int order) {
    String document =
        """
        <test_model><name>Counter</name><target interface="Counter"/><input_spec_list/>
          <sequence_spec length="%d" order="%d">
            <state name="count" type="int" initial="0"/>
            <call name="Add"><guard>count &lt; 6</guard>
              <update state="count">count + A</update>
              <input_spec_list><test_element abstract_type="NUMERIC" real_type="int">
                <name>A</name><type>TDI</type>
                <user_value_list><value>1</value><value>2</value></user_value_list>
              </test_element></input_spec_list></call>
            <call name="Take"><guard>count &gt; 0</guard>%s
              <update state="count">count - 1</update></call>
            <call name="Look">
              <output_spec_list><test_element abstract_type="NUMERIC" real_type="int">
                <name>return</name><type>RETURN</type>%s</test_element></output_spec_list></call>
          </sequence_spec>
          <order_of_combinations>1</order_of_combinations>
        </test_model>
        """
            .formatted(length, order, forbidden, expected);
    return TestModelXml.read(new ByteArrayInputStream(document.getBytes(UTF_8)), "Counter.xml");
  }

  private static CaseRecord ended(int no, Outcome outcome, String thrown, List<NamedValue> actual) {
    return new CaseRecord(no, outcome, thrown, actual, StubCalls.NONE, null, thrown);
  }

  /** The component. */
  private static CaseRecord execute(TestCase testCase) {
    int no = testCase.no();
    int count = 0;
    List<StepRecord> steps = new ArrayList<>();
    for (TestStep step : testCase.steps()) {
      CaseRecord record = ended(no, Outcome.RETURNED, "", List.of());
      switch (step.name()) {
        case "Add" -> count += Integer.parseInt(step.values().get(0));
        case "Take" -> {
          if (count == 0) {
            record = ended(no, Outcome.THREW, "Empty", List.of());
          } else {
            count--;
          }
        }
        default ->
            record =
                ended(
                    no,
                    Outcome.RETURNED,
                    "",
                    List.of(new NamedValue("return", Integer.toString(count))));
      }
      steps.add(new StepRecord(steps.size() + 1, step.name(), 0, record));
    }
    return ended(no, Outcome.RETURNED, "", List.of()).with(steps);
  }

  private static SequenceExecutions executions(TestModel model, int budget) {
    TestSuite suite = TestCaseGenerator.generate(model, GenerationOptions.DEFAULT).suite();
    return new SequenceExecutions(model, suite, null, List.of(), budget);
  }

  private static SpecificationScore score(TestModel model, int budget) {
    TestSuite suite = TestCaseGenerator.generate(model, GenerationOptions.DEFAULT).suite();
    SequenceExecutions executions = new SequenceExecutions(model, suite, null, List.of(), budget);
    Map<Integer, CaseRecord> records = new HashMap<>();
    executions.cases().cases().forEach(c -> records.put(c.no(), execute(c)));
    SequenceJudge judge =
        new SequenceJudge(
            executions, suite, List.of(), TrajectoryConditions.NONE, records, Map.of());
    assertThat(judge.baseline().values()).allMatch(r -> r.verdict() == Verdict.PASS);
    SpecificationScore score = judge.score();
    assertThat(score.injected())
        .isEqualTo(score.noticed() + score.equivalent() + score.survivors().size());
    return score;
  }

  private static List<String> faults(SequenceExecutions executions) {
    return executions.faults().stream().map(SequenceFault::text).toList();
  }

  @Test
  void stepsAreLeftOutRepeatedAndSwapped() {
    assertThat(faults(executions(model(WHOLE, FORBIDDEN, 6, 2), BUDGET)))
        .doesNotHaveDuplicates()
        .contains(
            "Add: left out",
            "Add: first one left out",
            "Take: last one left out",
            "Add: made twice, the first answer counts",
            "Take: made twice, the second answer counts",
            "Add: swapped with Look after it",
            "Look: swapped with Add after it",
            "Add.A: one too large",
            "Add.A: value of the call before",
            "Look.return: value of the call before",
            "Look.return: wrong value directly after Take",
            "Take.exception: swallowed, the outputs are never set");
  }

  @Test
  void aWholeSpecificationNoticesAllFaultsThatItsCasesShow() {
    SpecificationScore score = score(model(WHOLE, FORBIDDEN, 6, 3), BUDGET);

    assertThat(score.survivors()).allMatch(s -> s.suggestion().startsWith("no case shows it"));
    assertThat(score.share()).isGreaterThan(0.9);
    assertThat(score.noticed()).isGreaterThan(60);
    assertThat(score.byOutput()).containsOnlyKeys("Look.return");
    assertThat(score.warnings()).isEmpty();
  }

  @Test
  void withoutAnExpectedValueTheOrderOfStepsIsNotNoticed() {
    SpecificationScore score = score(model("", FORBIDDEN, 6, 3), BUDGET);

    assertThat(score.share()).isLessThan(score(model(WHOLE, FORBIDDEN, 6, 3), BUDGET).share());
    assertThat(score.warnings()).contains("nothing is expected of Look.return");
    assertThat(score.survivors())
        .filteredOn(s -> s.fault().equals("Look.return: value of the call before"))
        .singleElement()
        .extracting(Survivor::suggestion)
        .asString()
        .matches("add an expected value of return: case \\d+, step \\d+ \\(Look\\) gives .*");
    assertThat(score.survivors())
        .anyMatch(s -> s.fault().equals("Look: swapped with Add after it"));
  }

  @Test
  void aForbiddenCallWithAnyOutcomeHidesASwallowedException() {
    String swallowed = "Take.exception: swallowed, the outputs are never set";
    SpecificationScore strict = score(model(WHOLE, FORBIDDEN, 6, 2), BUDGET);
    SpecificationScore loose = score(model(WHOLE, "<forbidden>!any</forbidden>", 6, 2), BUDGET);

    assertThat(strict.survivors()).noneMatch(s -> s.fault().equals(swallowed));
    assertThat(loose.survivors())
        .filteredOn(s -> s.fault().equals(swallowed))
        .singleElement()
        .extracting(Survivor::suggestion)
        .asString()
        .startsWith("expect !error:Empty in case ")
        .contains(" (Take), and nothing else");
  }

  @Test
  void whatShortSequencesDoNotShowIsSuggestedAsACase() {
    SpecificationScore score = score(model(WHOLE, FORBIDDEN, 2, 1), BUDGET);

    assertThat(score.survivors())
        .extracting(Survivor::suggestion)
        .anyMatch(
            s ->
                s.startsWith(
                        "no case shows it: increase order or length of the sequence_spec, or add a"
                            + " case with ")
                    && s.contains("Look()"));
  }

  @Test
  void faultsBeyondTheBudgetAreNotCounted() {
    SequenceExecutions small = executions(model(WHOLE, FORBIDDEN, 6, 3), 3);

    assertThat(small.further()).isEqualTo(3);
    assertThat(small.notExecuted()).isPositive();
    assertThat(small.cases().cases()).extracting(TestCase::no).doesNotHaveDuplicates();
    assertThat(score(model(WHOLE, FORBIDDEN, 6, 3), 3).warnings())
        .anyMatch(w -> w.endsWith("more cases than --budget allows; increase it"));
  }
}
