package org.sitaf.core.trajectory;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.document.TestModelXml;

class TrajectoryConditionsTest {
  private static final long STEP_NANOS = 10_000_000;
  private static final List<String> SIGNALS =
      List.of("bumped", "robot_x", "ir1.range", "base.linear.command");

  @Test
  void aViolationNamesTheTimeAndTheSignals() throws Exception {
    double[] bumped = new double[500];
    bumped[342] = 1;

    TrajectoryOutcome outcome =
        outcome("always(bumped == 0.0)", Map.of(), Map.of("bumped", bumped));

    assertThat(outcome)
        .isEqualTo(
            new TrajectoryOutcome(
                "condition",
                false,
                -1,
                3_420_000_000L,
                "condition: broken at 3.42 s: bumped is 1",
                ""));
  }

  @Test
  void marginsAreDifferencesOfBothSides() throws Exception {
    Map<String, double[]> signals = Map.of("robot_x", new double[] {1, 2, 4});

    assertThat(margin("always(robot_x < 6.0)", signals)).isEqualTo(2);
    assertThat(margin("always(6.0 >= robot_x)", signals)).isEqualTo(2);
    assertThat(margin("eventually(robot_x > 5.0)", signals)).isEqualTo(-1);
    assertThat(margin("eventually(robot_x == 2.5)", signals)).isEqualTo(-0.5);
    assertThat(margin("eventually(robot_x == 2.0)", signals)).isZero();
    assertThat(margin("always(robot_x != 3.5)", signals)).isEqualTo(0.5);
    assertThat(margin("robot_x < 1.0", signals)).isZero();
    assertThat(outcome("robot_x < 1.0", Map.of(), signals).holds()).isFalse();
    assertThat(margin("(robot_x < 3.0 ? true : false)", signals)).isInfinite().isPositive();
    assertThat(margin("(robot_x < 3.0) == false", signals)).isInfinite().isNegative();
    assertThat(margin("always[5, 6](robot_x > 9.0)", signals)).isInfinite().isPositive();
    assertThat(margin("always(t <= 0.02)", signals)).isZero();
  }

  @Test
  void aConditionAfterTheEndOfTheCaseSaysThatItJudgesNothing() throws Exception {
    Map<String, double[]> signals = Map.of("robot_x", new double[] {1, 2, 4});

    TrajectoryOutcome holds = outcome("always[5, 6](robot_x > 9.0)", Map.of(), signals);
    TrajectoryOutcome broken = outcome("eventually[5, 6](robot_x > 0.0)", Map.of(), signals);

    String reason =
        "condition: no sample lies in its interval, which begins at 5 s; the case ends at 0.02 s";
    assertThat(holds.holds()).isTrue();
    assertThat(holds.note()).isEqualTo(reason);
    assertThat(broken.holds()).isFalse();
    assertThat(broken.violation()).isEqualTo(reason);
    assertThat(outcome("always[0.02, 6](robot_x > 3.0)", Map.of(), signals).note()).isEmpty();
  }

  @Test
  void numbersThatAreNotFiniteHaveInfiniteMargins() throws Exception {
    Map<String, double[]> signals = Map.of("ir1.range", new double[] {Double.NaN});
    Map<String, double[]> infinite = Map.of("ir1.range", new double[] {Double.POSITIVE_INFINITY});

    assertThat(margin("ir1.range > 0.0", signals)).isEqualTo(Double.NEGATIVE_INFINITY);
    assertThat(margin("ir1.range != 0.0", signals)).isEqualTo(Double.POSITIVE_INFINITY);
    assertThat(margin("ir1.range > 0.0", infinite)).isEqualTo(Double.POSITIVE_INFINITY);
    assertThat(margin("ir1.range == ir1.range", infinite)).isZero();
  }

  @Test
  void inputsAreConstants() throws Exception {
    Map<String, double[]> signals = Map.of("robot_x", new double[] {0, 0.5, 0.99, 1.01});

    assertThat(
            outcome(
                    "eventually[0, 0.02](always(robot_x - goal <= 0.02 && goal - robot_x <= 0.02))",
                    Map.of("goal", 1.0),
                    signals)
                .holds())
        .isTrue();
    assertThat(
            outcome("eventually[0, 0.02](always(robot_x >= goal))", Map.of("goal", 1.005), signals)
                .violation())
        .isEqualTo("condition: broken at 0.02 s: robot_x is 0.99");
  }

  @Test
  void knowsWhetherTheInputsAreValid() throws Exception {
    Map<String, double[]> signals = Map.of("robot_x", new double[] {5, 5});
    Map<String, Object> invalid = Map.of("goal", 1.0, "valid", false, "valid_goal", false);
    assertThat(outcome("valid -> always(robot_x < 2.0)", invalid, signals).holds()).isTrue();
    assertThat(outcome("!valid_goal && always(robot_x > 2.0)", invalid, signals).holds()).isTrue();
  }

  @Test
  void settlingHasNegativeTimes() throws Exception {
    double[] values = {5, 1, 1, 1};
    Trace trace = new Trace(-2 * STEP_NANOS, STEP_NANOS, List.of("robot_x"), List.of(values));
    TestModel model =
        model(
            "<trajectory_condition name='settling' from='settle'>always(robot_x &lt; 2.0)"
                + "</trajectory_condition><trajectory_condition name='call'>always(robot_x &lt; 2.0)"
                + "</trajectory_condition>");
    TrajectoryConditions conditions =
        TrajectoryConditions.compile(model, SIGNALS, 60, new Diagnostics());

    assertThat(conditions.needSettling()).isTrue();
    assertThat(conditions.evaluate(0, trace, Map.of()).violation())
        .isEqualTo("settling: broken at -0.02 s: robot_x is 5");
    assertThat(conditions.evaluate(1, trace, Map.of()))
        .isEqualTo(new TrajectoryOutcome("call", true, 1, STEP_NANOS, "", ""));
  }

  @Test
  void unknownSignalsNameThoseThatExist() {
    assertThat(problems("always(bump == 0.0)"))
        .containsExactly(
            "column 8 of the formula: 'bump == 0.0' is not a valid expression: unknown name 'bump';"
                + " did you mean 'bumped'?; signals: base.linear.command, bumped, ir1.range,"
                + " robot_x, t; inputs: goal");
    assertThat(problems("always(ir1.distance == 0.0)"))
        .singleElement()
        .asString()
        .contains("ir1.range");
  }

  @Test
  void anAtomMustBeTrueOrFalse() {
    assertThat(problems("always(bumped) && once(robot_x > 1.0) && (bumped > 0.0 ? true : false)"))
        .containsExactly(
            "column 8 of the formula: 'bumped' is neither true nor false; compare it, such as =="
                + " 0.0");
    assertThat(problems("always(goal)"))
        .singleElement()
        .asString()
        .contains("'goal' is neither true nor false");
  }

  @Test
  void allProblemsAreReportedAtOnce() {
    assertThat(problems("always[61, 62](bump == 0.0) && ir == 1.0")).hasSize(3);
  }

  @Test
  void aNameMustHaveOneMeaning() {
    Diagnostics diagnostics = new Diagnostics();
    TrajectoryConditions unused =
        TrajectoryConditions.compile(
            model(condition("always(goal < 1.0 && bumped < 1.0)")),
            List.of("goal", "bumped", "bumped"),
            60,
            diagnostics);

    assertThat(diagnostics.all()).hasSize(2);
    assertThat(diagnostics.all().get(0).message()).contains("'goal' is two signals");
  }

  @Test
  void anIntervalMustBeginWithinTheCase() {
    assertThat(problems("always[60, 61](bumped == 0.0)")).isEmpty();
    assertThat(problems("always[60.5, 61](bumped == 0.0)"))
        .singleElement()
        .asString()
        .contains("begins at 60.5 s")
        .contains("limits.case_sim_s");
  }

  @Test
  void positionsAreThoseOfTheDocument() {
    Diagnostics diagnostics = new Diagnostics();
    TrajectoryConditions unused =
        TrajectoryConditions.compile(
            model(condition("\n  always(bumped == 0.0\n &&)")), SIGNALS, 60, diagnostics);

    assertThat(diagnostics.all().get(0).line()).isEqualTo(6);
  }

  @Test
  void usesOnlyTheSignalsThatItNames() {
    TrajectoryConditions conditions =
        TrajectoryConditions.compile(
            model(condition("always(bumped == 0.0 && t + goal > ir1.range)")),
            SIGNALS,
            60,
            new Diagnostics());

    assertThat(conditions.signals()).containsExactly("bumped", "ir1.range");
    assertThat(conditions.beyond(1 << 20, 1_000)).isEmpty();
    assertThat(conditions.beyond(1 << 20, 1_000_000)).containsOnlyKeys("condition");
  }

  @Test
  void theSpanOfAConditionIsTheIntervalOfItsOutermostOperators() {
    assertThat(span("eventually[0.1, 2](always[0, 1](bumped == 0.0))", 500))
        .isEqualTo(new ConditionSpan("condition", 100_000_000, 2_000_000_000, List.of("bumped")));
    assertThat(span("always(bumped == 0.0)", 101).toNanos()).isEqualTo(1_000_000_000);
    assertThat(span("bumped == 0.0 && always[1, 2](t < 5.0)", 500))
        .isEqualTo(new ConditionSpan("condition", 0, 2_000_000_000, List.of("bumped")));
    assertThat(span("once(bumped == 0.0)", 500).toNanos()).isZero();
    ConditionSpan late = span("(robot_x > 0.0) until[3, 4] (bumped == 1.0)", 101);
    assertThat(late.fromNanos()).isEqualTo(1_000_000_000).isEqualTo(late.toNanos());
    assertThat(late.signals()).containsExactlyInAnyOrder("robot_x", "bumped");
  }

  @Test
  void theSpanOfAConditionWithSettlingBeginsBeforeTheCall() {
    String settling =
        "<trajectory_condition name='condition' from='settle'>always[0, 0.3](bumped == 0.0)"
            + "</trajectory_condition>";
    Trace trace = new Trace(-200_000_000, STEP_NANOS, List.of("bumped"), List.of(new double[100]));

    assertThat(compiled(settling).spans(trace))
        .containsExactly(
            new ConditionSpan("condition", -200_000_000, 100_000_000, List.of("bumped")));
  }

  private static ConditionSpan span(String formula, int count) {
    Trace trace = new Trace(0, STEP_NANOS, List.of("bumped"), List.of(new double[count]));
    return compiled(condition(formula)).spans(trace).get(0);
  }

  private static TrajectoryConditions compiled(String conditions) {
    Diagnostics diagnostics = new Diagnostics();
    TrajectoryConditions compiled =
        TrajectoryConditions.compile(model(conditions), SIGNALS, 60, diagnostics);
    assertThat(diagnostics.all()).isEmpty();
    return compiled;
  }

  private static double margin(String formula, Map<String, double[]> signals) throws Exception {
    return outcome(formula, Map.of("goal", 1.0), signals).margin();
  }

  private static TrajectoryOutcome outcome(
      String formula, Map<String, Object> inputs, Map<String, double[]> signals) throws Exception {
    Diagnostics diagnostics = new Diagnostics();
    TrajectoryConditions conditions =
        TrajectoryConditions.compile(model(condition(formula)), SIGNALS, 60, diagnostics);
    assertThat(diagnostics.all()).isEmpty();
    List<String> names = new ArrayList<>(signals.keySet());
    return conditions.evaluate(
        0, new Trace(0, STEP_NANOS, names, names.stream().map(signals::get).toList()), inputs);
  }

  private static List<String> problems(String formula) {
    Diagnostics diagnostics = new Diagnostics();
    TrajectoryConditions unused =
        TrajectoryConditions.compile(model(condition(formula)), SIGNALS, 60, diagnostics);
    return diagnostics.all().stream().map(d -> d.message()).toList();
  }

  private static String condition(String formula) {
    return "<trajectory_condition name='condition'>"
        + formula.replace("&", "&amp;").replace("<", "&lt;")
        + "</trajectory_condition>";
  }

  private static TestModel model(String conditions) {
    String document =
        """
        <test_model><name>Model</name><description/><input_spec_list>
        <test_element abstract_type="NUMERIC" real_type="double"><name>goal</name><type>TDI</type>
        <user_value_list><value>1.0</value></user_value_list></test_element></input_spec_list>
        <trajectory_condition_spec_list>%s</trajectory_condition_spec_list>
        <order_of_combinations>1</order_of_combinations></test_model>
        """
            .formatted(conditions);
    return TestModelXml.read(
        new ByteArrayInputStream(document.getBytes(StandardCharsets.UTF_8)), "model.xml");
  }
}
