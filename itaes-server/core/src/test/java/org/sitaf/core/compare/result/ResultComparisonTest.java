package org.sitaf.core.compare.result;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.compare.CaseComparison;
import org.sitaf.core.compare.CaseRun;
import org.sitaf.core.compare.Comparison;
import org.sitaf.core.compare.Difference;
import org.sitaf.core.compare.DifferenceClass;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.GenerationOptions;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestCaseGenerator;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.timing.RepeatedCalls;
import org.sitaf.core.trajectory.Trace;
import org.sitaf.core.verdict.CaseRecord;
import org.sitaf.core.verdict.CaseRecord.Outcome;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.Coverage;
import org.sitaf.core.verdict.NamedValue;
import org.sitaf.core.verdict.Provenance;
import org.sitaf.core.verdict.ResultAssembler;
import org.sitaf.core.verdict.StubCalls;
import org.sitaf.core.verdict.StubCalls.Call;
import org.sitaf.core.verdict.TestResult;
import org.sitaf.core.verdict.document.TestResultXml;

class ResultComparisonTest {
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
                <user_value_list><value>1</value><value>2</value><value>3</value><value>4</value>
                  <value>5</value><value>6</value></user_value_list></test_element>
            </input_spec_list>
            <output_spec_list>
              <test_element abstract_type="NUMERIC" real_type="double"><name>reached</name><type>OUT</type>
                <expected>speed > 5.0 ? "!error:TooFast" : speed</expected></test_element>
            </output_spec_list>
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
  private final ResultAssembler assembler = new ResultAssembler(model, suite, activity.required());

  /** The records of both versions by the value of {@code speed}. */
  private CaseRecord base(TestCase of) {
    return switch (speed(of)) {
      case 6 -> threw(of, "TooFast", "robot.TooFast: 6.0 at robot.Arm.move(Arm.java:12)");
      default -> returned(of, "0.5", of.values().get(0), of.values().get(0));
    };
  }

  private CaseRecord now(TestCase of) {
    String value = of.values().get(0);
    return switch (speed(of)) {
      // A value that the model does not name.
      case 1 -> returned(of, "0.75", value, value);
      case 2 ->
          threw(
              of,
              "IllegalStateException",
              "java.lang.IllegalStateException: no at a.B.c(B.java:1)");
      case 3 -> returned(of, "0.5", value, "3.5");
      case 4 -> returned(of, Float.toString(Math.nextUp(0.5f)), value, value);
      case 6 -> threw(of, "TooFast", "robot.TooFast: 6.0 at robot.Arm.move(Arm.java:15)");
      default -> returned(of, "0.5", value, value);
    };
  }

  private static int speed(TestCase of) {
    return (int) Double.parseDouble(of.values().get(0));
  }

  private static CaseRecord returned(TestCase of, String value, String reached, String driven) {
    return new CaseRecord(
        of.no(),
        Outcome.RETURNED,
        "",
        List.of(new NamedValue("return", value), new NamedValue("reached", reached)),
        new StubCalls(
            List.of(new Call("Motor.Drive", List.of(new NamedValue("speed", driven)))), 0),
        new CaseResult.ProcessingTime(1, 0, 0),
        "");
  }

  private static CaseRecord threw(TestCase of, String type, String message) {
    return new CaseRecord(of.no(), Outcome.THREW, type, List.of(), StubCalls.NONE, null, message);
  }

  /** The result of recorded cases, as it is after its document was stored and read. */
  private TestResult result(Function<TestCase, CaseRecord> records) {
    return stored(suite.cases().stream().map(c -> assembler.judge(records.apply(c))).toList());
  }

  private TestResult stored(List<CaseResult> results) {
    ByteArrayOutputStream document = new ByteArrayOutputStream();
    TestResultXml.write(
        assembler.assemble(results, "missing", new Provenance("", 1, "", "", "", "", "", "")),
        document);
    return TestResultXml.read(new ByteArrayInputStream(document.toByteArray()), "result");
  }

  private Comparison compare(TestResult base, TestResult now) {
    return compare(side(base), side(now));
  }

  private Comparison compare(ResultComparison.Side base, ResultComparison.Side now) {
    return ResultComparison.of(
        new ResultComparison.Context(
            activity, model, suite, true, path -> path.equals("Same.java")),
        base,
        now);
  }

  private static ResultComparison.Side side(TestResult result) {
    return new ResultComparison.Side(result, no -> null);
  }

  @Test
  void results_differ_as_the_records_that_they_were_made_of() {
    CaseComparison ofRecords = new CaseComparison(activity, model, suite, 4, true);
    List<Difference> differences = new ArrayList<>();
    List<Difference> lastBits = new ArrayList<>();
    for (TestCase each : suite.cases()) {
      var found =
          ofRecords.compare(
              each,
              new CaseRun(base(each), assembler.judge(base(each)), null),
              new CaseRun(now(each), assembler.judge(now(each)), null));
      differences.addAll(found.differences());
      lastBits.addAll(found.lastBits());
    }
    assertThat(differences)
        .extracting(Difference::kind)
        .containsExactlyInAnyOrder(
            DifferenceClass.VALUE, DifferenceClass.ERROR, DifferenceClass.CALLS);
    assertThat(lastBits).hasSize(1);
    Comparison found = compare(result(this::base), result(this::now));
    assertThat(found.differences()).isEqualTo(differences);
    assertThat(found.lastBits()).isEqualTo(lastBits);
    assertThat(found.cases()).hasSize(suite.cases().size());
    assertThat(found.notComparable()).isEmpty();
  }

  @Test
  void cases_are_matched_by_their_values() {
    TestResult base = result(this::base);
    List<CaseResult> reversed = new ArrayList<>(base.cases());
    Collections.reverse(reversed);
    List<CaseResult> renumbered = new ArrayList<>();
    for (CaseResult each : reversed.subList(1, reversed.size())) {
      renumbered.add(
          new CaseResult(
              100 + each.no(),
              each.verdict(),
              each.values(),
              each.expected(),
              each.actual(),
              each.calls(),
              each.time(),
              each.message()));
    }
    TestResult other =
        new TestResult(
            base.name(), base.provenance(), base.summary(), base.parameters(), renumbered, null);
    Comparison found = compare(other, base);
    assertThat(found.differences()).isEmpty();
    assertThat(found.cases()).hasSize(suite.cases().size() - 1);
    assertThat(found.notComparable())
        .extracting(n -> n.reason())
        .containsExactly("1 case is only in NEW");
  }

  @Test
  void an_exception_whose_message_is_not_stored_is_compared_by_its_type() {
    TestCase tooFast = suite.cases().stream().filter(c -> speed(c) == 6).findFirst().orElseThrow();
    CaseResult expected = assembler.judge(base(tooFast));
    assertThat(expected.message()).as("an expected exception").isEmpty();
    CaseResult unexpected =
        new CaseResult(
            tooFast.no(),
            org.sitaf.core.verdict.Verdict.ERROR,
            tooFast.values(),
            List.of(),
            List.of(),
            null,
            "robot.TooFast: 6.0");
    RecordsOfResults records = new RecordsOfResults(model);
    RecordsOfResults.Pair pair = records.of(expected, unexpected);
    assertThat(pair.base().thrown()).isEqualTo("TooFast");
    assertThat(pair.now().thrown()).isEqualTo("TooFast");
    assertThat(pair.now().message()).isEmpty();
  }

  @Test
  void a_case_that_returned_but_could_not_be_judged_is_no_exception() {
    CaseResult result =
        new CaseResult(
            1,
            org.sitaf.core.verdict.Verdict.ERROR,
            List.of("1"),
            List.of(),
            List.of(),
            null,
            "post-condition cannot be evaluated: x: division by zero");
    assertThat(new RecordsOfResults(model).of(result, result).now().outcome())
        .isEqualTo(Outcome.RETURNED);
  }

  @Test
  void the_first_divergent_step_of_signals_is_found() {
    TestResult result = result(this::base);
    Comparison found =
        compare(
            new ResultComparison.Side(result, no -> no == 1 ? trace(0, 1, 2) : null),
            new ResultComparison.Side(result, no -> no == 1 ? trace(0, 1, 3) : null));
    assertThat(found.differences()).hasSize(1);
    assertThat(found.differences().get(0).kind()).isEqualTo(DifferenceClass.TRAJECTORY);
    assertThat(found.differences().get(0).at()).isEqualTo(0.02);
  }

  private static Trace trace(double... x) {
    return new Trace(0, 10_000_000, List.of("x"), List.of(x));
  }

  @Test
  void slower_cases_are_found_by_their_repeated_calls() {
    Comparison found = compare(timed(1_000), timed(3_000));
    assertThat(found.differences()).isEmpty();
    assertThat(found.slower()).hasSize(suite.cases().size());
  }

  private TestResult timed(long nanos) {
    return stored(
        suite.cases().stream()
            .map(c -> assembler.judge(base(c)))
            .map(
                r ->
                    r.with(
                        RepeatedCalls.of(
                            1, LongStream.range(0, 20).map(i -> nanos + i).toArray(), "")))
            .toList());
  }

  @Test
  void lost_lines_count_in_sources_that_did_not_change() {
    TestResult result = result(this::base);
    Comparison found = compare(result.with(covered(1)), result.with(covered(0)));
    assertThat(found.differences()).extracting(Difference::output).containsExactly("Same.java");
  }

  private static Coverage covered(int count) {
    return new Coverage(
        List.of(
            new Coverage.File("Changed.java", List.of(new Coverage.Line(3, count > 0, 0, 0))),
            new Coverage.File("Same.java", List.of(new Coverage.Line(3, count > 0, 0, 0)))));
  }

  @Test
  void a_component_that_never_begins_is_not_comparable() {
    Function<TestCase, CaseRecord> broken =
        c -> CaseRecord.error(c.no(), "the component could not be created");
    Comparison found = compare(result(broken), result(broken));
    assertThat(found.cases()).isEmpty();
    assertThat(found.notComparable())
        .extracting(n -> n.reason())
        .containsExactly("no case begins with either version: the component could not be created");
  }

  @Test
  void results_with_other_parameters_are_refused() {
    TestResult result = result(this::base);
    TestResult other =
        new TestResult(
            result.name(), result.provenance(), result.summary(), List.of(), List.of(), null);
    assertThatThrownBy(() -> compare(other, result)).isInstanceOf(IllegalArgumentException.class);
  }
}
