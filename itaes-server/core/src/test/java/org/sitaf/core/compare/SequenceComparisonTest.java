package org.sitaf.core.compare;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.GenerationOptions;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestCaseGenerator;
import org.sitaf.core.suite.TestStep;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.verdict.CaseRecord;
import org.sitaf.core.verdict.CaseRecord.Outcome;
import org.sitaf.core.verdict.NamedValue;
import org.sitaf.core.verdict.ResultAssembler;
import org.sitaf.core.verdict.StepRecord;
import org.sitaf.core.verdict.StubCalls;

class SequenceComparisonTest {
  private static final Map<String, String> FILES =
      Map.of(
          "activity.yaml",
          """
          name: counter
          component: {language: java, sources: component/, class: robot.Counter}
          provided: [counter.idl]
          models: [model.xml]
          """,
          "counter.idl",
          "interface Counter { void Add(in long by); double Get(); };",
          "model.xml",
          """
          <test_model><name>Count</name><target interface="Counter"/>
            <input_spec_list/>
            <sequence_spec length="4" order="2">
              <call name="Add">
                <input_spec_list>
                  <test_element abstract_type="NUMERIC" real_type="int"><name>by</name><type>TDI</type>
                    <user_value_list><value>1</value></user_value_list></test_element>
                </input_spec_list>
              </call>
              <call name="Read" method="Get"/>
            </sequence_spec>
            <order_of_combinations>1</order_of_combinations>
          </test_model>
          """);

  private final Activity activity =
      Activity.readWithoutComponent(
          FileTree.of(
              FILES.entrySet().stream()
                  .collect(
                      Collectors.toMap(
                          Map.Entry::getKey, e -> e.getValue().getBytes(StandardCharsets.UTF_8)))));
  private final TestModel model = activity.models().get(0);
  private final TestSuite suite =
      TestCaseGenerator.generate(model, GenerationOptions.DEFAULT).suite();

  /** A case with at least two readings. */
  private final TestCase testCase =
      suite.cases().stream().filter(c -> reads(c).size() >= 2).findFirst().orElseThrow();

  private static List<Integer> reads(TestCase of) {
    List<Integer> reads = new ArrayList<>();
    for (int i = 0; i < of.steps().size(); i++) {
      if (of.steps().get(i).name().equals("Read")) {
        reads.add(i);
      }
    }
    return reads;
  }

  private static CaseRecord record(Outcome outcome, String thrown, List<NamedValue> actual) {
    return new CaseRecord(1, outcome, thrown, actual, StubCalls.NONE, null, thrown);
  }

  /** A run whose readings are these; an empty one throws. */
  private CaseRun run(String... readings) {
    List<StepRecord> steps = new ArrayList<>();
    int read = 0;
    for (TestStep step : testCase.steps()) {
      CaseRecord ended = record(Outcome.RETURNED, "", List.of());
      if (step.name().equals("Read")) {
        String reading = readings[Math.min(read++, readings.length - 1)];
        ended =
            reading.isEmpty()
                ? record(Outcome.THREW, "Broken", List.of())
                : record(Outcome.RETURNED, "", List.of(new NamedValue("return", reading)));
      }
      steps.add(new StepRecord(steps.size() + 1, step.name(), 0, ended));
    }
    CaseRecord record =
        new CaseRecord(testCase.no(), Outcome.RETURNED, "", List.of(), StubCalls.NONE, null, "")
            .with(steps);
    return new CaseRun(
        record, new ResultAssembler(model, suite, activity.required()).judge(record), null);
  }

  private CaseDifferences compare(CaseRun base, CaseRun now) {
    return new CaseComparison(activity, model, suite, 4, true).compare(testCase, base, now);
  }

  @Test
  void equal_steps_do_not_differ() {
    assertThat(compare(run("1.0"), run("1.0")).differences()).isEmpty();
  }

  @Test
  void the_first_step_that_differs_is_named_and_no_later_one() {
    List<Difference> found = compare(run("1.0", "2.0"), run("1.0", "3.0")).differences();
    assertThat(found).hasSize(1);
    int number = reads(testCase).get(1) + 1;
    assertThat(found.get(0).step()).isEqualTo(new Difference.Step(number, "Read()"));
    assertThat(found.get(0).output()).isEqualTo("Read.return");
    assertThat(found.get(0).base()).isEqualTo("2.0");
    assertThat(found.get(0).now()).isEqualTo("3.0");
    assertThat(found.get(0).deviation()).isEqualTo(1);
  }

  @Test
  void an_exception_of_a_step_is_a_difference_of_this_step() {
    List<Difference> found = compare(run("1.0"), run("")).differences();
    assertThat(found).hasSize(1);
    assertThat(found.get(0).kind()).isEqualTo(DifferenceClass.ERROR);
    assertThat(found.get(0).output()).isEqualTo("Read");
    assertThat(found.get(0).change()).isEqualTo("Broken in NEW only");
    assertThat(found.get(0).step())
        .isEqualTo(new Difference.Step(reads(testCase).get(0) + 1, "Read()"));
  }

  @Test
  void the_last_bits_of_a_step_do_not_count() {
    CaseDifferences found = compare(run("1.0"), run(Double.toString(Math.nextUp(1.0))));
    assertThat(found.differences()).isEmpty();
    assertThat(found.lastBits()).extracting(Difference::output).contains("Read.return");
  }

  @Test
  void an_earlier_step_that_is_unstable_casts_doubt_on_a_later_one() {
    Difference early = compare(run("1.0", "2.0"), run("", "2.0")).differences().get(0);
    Difference late = compare(run("1.0", "2.0"), run("1.0", "3.0")).differences().get(0);
    assertThat(early.castsDoubtOn(late)).isTrue();
  }
}
