package org.sitaf.core.compare;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.GenerationOptions;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestCaseGenerator;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.trajectory.Trace;
import org.sitaf.core.verdict.CaseRecord;
import org.sitaf.core.verdict.CaseRecord.Outcome;
import org.sitaf.core.verdict.NamedValue;
import org.sitaf.core.verdict.ResultAssembler;
import org.sitaf.core.verdict.StubCalls;
import org.sitaf.core.verdict.StubCalls.Call;

class CaseComparisonTest {
  private static final Map<String, String> FILES =
      Map.of(
          "activity.yaml",
          """
          name: arm
          component: {language: java, sources: component/, class: robot.Arm}
          provided: [arm.idl]
          required: [motor.idl]
          models: [model.xml]
          """,
          "arm.idl",
          "interface Arm { float Move(in double speed, out double reached); };",
          "motor.idl",
          "interface Motor { void Drive(in double speed); };",
          "model.xml",
          """
          <test_model><name>Move</name>
            <input_spec_list>
              <test_element abstract_type="NUMERIC" real_type="double"><name>speed</name><type>TDI</type>
                <user_value_list><value>1</value><value>2</value></user_value_list></test_element>
            </input_spec_list>
            <output_spec_list>
              <test_element abstract_type="NUMERIC" real_type="double"><name>reached</name><type>OUT</type>
                <expected>speed</expected></test_element>
            </output_spec_list>
            <order_of_combinations>2</order_of_combinations>
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
  private final TestCase testCase = suite.cases().get(0);

  private CaseRun run(CaseRecord record, @Nullable Trace signals) {
    return new CaseRun(
        record, new ResultAssembler(model, suite, activity.required()).judge(record), signals);
  }

  private CaseRun returned(String value, String reached, Call... calls) {
    return run(
        new CaseRecord(
            1,
            Outcome.RETURNED,
            "",
            List.of(new NamedValue("return", value), new NamedValue("reached", reached)),
            new StubCalls(List.of(calls), 0),
            null,
            ""),
        null);
  }

  private CaseRun threw(String type, String message) {
    return run(
        new CaseRecord(1, Outcome.THREW, type, List.of(), StubCalls.NONE, null, message), null);
  }

  private static Call drive(String speed) {
    return new Call("Motor.Drive", List.of(new NamedValue("speed", speed)));
  }

  private CaseDifferences compare(CaseRun base, CaseRun now) {
    return new CaseComparison(activity, model, suite, 4, true).compare(testCase, base, now);
  }

  private Difference only(CaseRun base, CaseRun now) {
    CaseDifferences found = compare(base, now);
    assertThat(found.differences()).hasSize(1);
    return found.differences().get(0);
  }

  @Test
  void aValueThatTheModelDoesNotNameIsCompared() {
    Difference found = only(returned("0.5", "1.0"), returned("0.75", "1.0"));
    assertThat(found.kind()).isEqualTo(DifferenceClass.VALUE);
    assertThat(found.output()).isEqualTo("return");
    assertThat(found.base()).isEqualTo("0.5");
    assertThat(found.now()).isEqualTo("0.75");
    assertThat(found.inputs()).containsExactly(Map.entry("speed", "1.0"));
    assertThat(found.deviation()).isEqualTo(0.25);
  }

  @Test
  void thePrecisionIsThatOfTheInterface() {
    CaseDifferences found = compare(returned("1.0", "1.0"), returned("1.0000001", "1.0"));
    assertThat(found.differences()).isEmpty();
    assertThat(found.lastBits()).extracting(Difference::output).containsExactly("return");
    assertThat(only(returned("1.0", "1.0"), returned("1.0", "1.0000001")).output())
        .isEqualTo("reached");
  }

  @Test
  void anExceptionHidesTheValuesThatItPrevents() {
    Difference found =
        only(returned("0.5", "1.0"), threw("NoEcho", "a.NoEcho: far at A.f(A.java:1)"));
    assertThat(found.kind()).isEqualTo(DifferenceClass.ERROR);
    assertThat(found.base()).isEqualTo("return = 0.5, reached = 1.0");
    assertThat(found.now()).isEqualTo("NoEcho: far");
    assertThat(found.change()).isEqualTo("NoEcho in NEW only");
    assertThat(
            compare(threw("E", "E: x at f (a.py:1)"), threw("E", "E: x at g (b.py:2)"))
                .differences())
        .isEmpty();
    assertThat(only(threw("E", "E: x"), threw("E", "E: y")).change())
        .isEqualTo("other message of E");
  }

  @Test
  void theOrderAndArgumentsOfCallsAreCompared() {
    CaseRun base = returned("1.0", "1.0", drive("1.0"), drive("2.0"));
    Difference order = only(base, returned("1.0", "1.0", drive("2.0"), drive("1.0")));
    assertThat(order.kind()).isEqualTo(DifferenceClass.CALLS);
    assertThat(order.output()).isEqualTo("Motor.Drive");
    assertThat(order.base()).isEqualTo("call 1: Motor.Drive(speed=1.0)");
    Difference missing = only(base, returned("1.0", "1.0", drive("1.0")));
    assertThat(missing.now()).isEqualTo("no call 2");
    assertThat(
            compare(base, returned("1.0", "1.0", drive("1.0000000000000002"), drive("2.0")))
                .lastBits())
        .extracting(Difference::kind)
        .containsExactly(DifferenceClass.CALLS);
  }

  @Test
  void commandsAndMotionHaveTheirFirstStep() {
    CaseRecord record =
        new CaseRecord(1, Outcome.RETURNED, "", List.of(), StubCalls.NONE, null, "");
    List<String> names = List.of("base.linear.command", "robot_x");
    Trace base = new Trace(0, 500_000_000, names, List.of(new double[] {0, 1, 1}, new double[3]));
    Trace now =
        new Trace(0, 500_000_000, names, List.of(new double[] {0, 2, 2}, new double[] {0, 0, 0.5}));
    List<Difference> found = compare(run(record, base), run(record, now)).differences();
    assertThat(found)
        .extracting(Difference::kind)
        .containsExactly(DifferenceClass.COMMANDS, DifferenceClass.TRAJECTORY);
    assertThat(found).extracting(Difference::at).containsExactly(0.5, 1.0);
    assertThat(found).extracting(Difference::now).containsExactly("2.0", "0.5");
  }

  @Test
  void aVerdictCountsOnlyIfNothingElseDiffers() {
    CaseRun passed = returned("1.0", "1.0");
    CaseRun failed = returned("1.0", "1.0000000000000002");
    assertThat(only(passed, failed).kind()).isEqualTo(DifferenceClass.VERDICT);
    assertThat(only(passed, returned("1.0", "3.0")).kind()).isEqualTo(DifferenceClass.VALUE);
    assertThat(
            new CaseComparison(activity, model, suite, 4, false)
                .compare(testCase, passed, failed)
                .differences())
        .isEmpty();
  }

  @Test
  void aCaseThatWasNotExecutedIsNotComparable() {
    CaseRun missing =
        new CaseRun(
            null,
            new ResultAssembler(model, suite)
                .without(1, org.sitaf.core.verdict.Verdict.DONT, "the process ended too often"),
            null);
    CaseDifferences found = compare(returned("1.0", "1.0"), missing);
    assertThat(found.isCompared()).isFalse();
    assertThat(found.differences()).isEmpty();
    assertThat(found.notComparable())
        .containsExactly(
            new NotComparable("Move", 1, "", "not executed with NEW: the process ended too often"));
  }

  @Test
  void anOutputOfOneVersionIsNotComparable() {
    CaseRun less =
        run(
            new CaseRecord(
                1,
                Outcome.RETURNED,
                "",
                List.of(new NamedValue("reached", "1.0")),
                StubCalls.NONE,
                null,
                ""),
            null);
    CaseDifferences found = compare(less, returned("1.0", "1.0"));
    assertThat(found.isCompared()).isTrue();
    assertThat(found.notComparable())
        .containsExactly(new NotComparable("Move", 1, "return", "only NEW has it"));
  }
}
