package org.sitaf.core.trajectory;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.sitaf.core.diagnostic.Diagnostic;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.expression.EvaluationException;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.document.TestModelXml;

/** Signals that are elements of lists, such as the ranges of a laser scanner. */
class ListSignalsTest {
  private static final long STEP_NANOS = 10_000_000;
  private static final Map<String, Integer> LISTS = Map.of("lidar.ranges", 12);
  private static final double INF = Double.POSITIVE_INFINITY;

  @Test
  void onlyTheElementsThatAConditionNamesAreSampled() {
    TrajectoryConditions conditions =
        compiled("always(lidar.ranges[10] > 0.3 && lidar.ranges[2] > robot_x)");

    assertThat(conditions.signals())
        .containsExactly("lidar.ranges[10]", "lidar.ranges[2]", "robot_x");
    assertThat(conditions.plotted()).isEqualTo(conditions.signals());
  }

  @Test
  void aListAsAWholeIsSampledWithAllElementsAndPlottedWithItsExtremes() {
    for (String formula :
        List.of(
            "always(min(lidar.ranges) > 0.3)",
            "always(lidar.ranges.all(r, r > 0.3))",
            "always(lidar.ranges[int(goal)] > 0.3)")) {
      TrajectoryConditions conditions = compiled(formula);
      assertThat(conditions.signals()).hasSize(12).contains("lidar.ranges[0]", "lidar.ranges[11]");
      assertThat(conditions.plotted()).containsExactly("max(lidar.ranges)", "min(lidar.ranges)");
    }
  }

  @Test
  void aListWhoseLengthIsNotKnownHasSingleElementsOnly() {
    Map<String, Integer> lists = Map.of("joints.position", TrajectoryConditions.ANY_LENGTH);

    assertThat(
            compiled("always(joints.position[7] < joints.position[1])", lists, new Diagnostics())
                .signals())
        .containsExactly("joints.position[1]", "joints.position[7]");
    for (String formula :
        List.of(
            "always(max(joints.position) < 1.0)",
            "always(joints.position[int(goal)] < 1.0)",
            "always(joints.position[10000] < 1.0)")) {
      Diagnostics diagnostics = new Diagnostics();
      var unused = compiled(formula, lists, diagnostics);
      assertThat(diagnostics.all())
          .as(formula)
          .singleElement()
          .asString()
          .containsAnyOf(
              "each message gives the length of 'joints.position'; use single elements such as"
                  + " joints.position[0]",
              "an index of 'joints.position' must be from 0 to 9999");
    }
  }

  @Test
  void anElementIsASignal() throws EvaluationException {
    Trace trace =
        new Trace(
            0,
            STEP_NANOS,
            List.of("lidar.ranges[7]", "lidar.ranges[3]"),
            List.of(new double[] {2, 0.25, INF}, new double[] {9, 8, 7}));
    String formula = "always(lidar.ranges[7] >= 0.5 && lidar.ranges[3] > 1.0)";

    assertThat(compiled(formula).evaluate(0, trace, Map.of()))
        .isEqualTo(
            new TrajectoryOutcome(
                "condition",
                false,
                -0.25,
                STEP_NANOS,
                "condition: broken at 0.01 s: lidar.ranges[7] is 0.25",
                ""));
  }

  @Test
  void aListAsAWholeHasItsMarginAndShowsItsExtremes() throws EvaluationException {
    TrajectoryOutcome smallest = outcome("always(min(lidar.ranges) >= 0.5)", Map.of());

    assertThat(smallest.holds()).isFalse();
    assertThat(smallest.margin()).isCloseTo(-0.1, within(1e-12));
    assertThat(smallest.violation())
        .isEqualTo(
            "condition: broken at 0.02 s: max(lidar.ranges) is inf, min(lidar.ranges) is 0.4");
    assertThat(outcome("always(lidar.ranges.all(r, r >= 0.5))", Map.of()).margin()).isEqualTo(-INF);
    assertThat(outcome("always(lidar.ranges.all(r, r >= 0.4))", Map.of()).holds()).isTrue();
    assertThat(outcome("eventually(lidar.ranges[int(goal)] < 0.5)", Map.of("goal", 5.0)).holds())
        .isTrue();
    assertThat(outcome("eventually(lidar.ranges[int(goal)] < 0.5)", Map.of("goal", 4.0)).holds())
        .isFalse();
    assertThat(outcome("always(size(lidar.ranges) == 12)", Map.of()).holds()).isTrue();
  }

  @Test
  void plotsTheExtremesOfEachSample() {
    Trace plotted = compiled("always(min(lidar.ranges) >= 0.5)").plotted(trace());

    assertThat(plotted.names()).containsExactly("max(lidar.ranges)", "min(lidar.ranges)");
    assertThat(plotted.columns().get(0)).containsExactly(INF, INF, INF);
    assertThat(plotted.columns().get(1)).containsExactly(1, 1, 0.4);
  }

  @Test
  void elementsThatDoNotExistAreErrorsWithTheirLine() {
    assertThat(problems("\n always(lidar.ranges[12] > 0.3)"))
        .containsExactly(
            "5: column 8 of the formula: lidar.ranges[12] does not exist; the last element is"
                + " lidar.ranges[11]");
    assertThat(problems("always(lidar.ranges[-1] > 0.3)"))
        .singleElement()
        .asString()
        .contains("[-1]");
    assertThat(problems("always(lidar.range[1] > 0.3)"))
        .singleElement()
        .asString()
        .contains("lidar.ranges[0] to lidar.ranges[11], robot_x, t; inputs: goal");
    assertThat(problems("always(lidar.ranges > 0.3)")).hasSize(1);
    assertThat(problems("always(lidar.ranges[1].x > 0.3)")).hasSize(1);
  }

  private static TrajectoryOutcome outcome(String formula, Map<String, Object> inputs)
      throws EvaluationException {
    return compiled(formula).evaluate(0, trace(), inputs);
  }

  /** All ranges are 1 m; the first is out of reach; in the last sample the sixth is 0.4 m. */
  private static Trace trace() {
    double[][] columns = new double[12][3];
    Arrays.stream(columns).forEach(c -> Arrays.fill(c, 1));
    Arrays.fill(columns[0], INF);
    columns[5][2] = 0.4;
    List<String> names =
        java.util.stream.IntStream.range(0, 12).mapToObj(i -> "lidar.ranges[" + i + "]").toList();
    return new Trace(0, STEP_NANOS, names, List.of(columns));
  }

  private static TrajectoryConditions compiled(String formula) {
    Diagnostics diagnostics = new Diagnostics();
    TrajectoryConditions conditions = compiled(formula, LISTS, diagnostics);
    assertThat(diagnostics.all()).isEmpty();
    return conditions;
  }

  private static TrajectoryConditions compiled(
      String formula, Map<String, Integer> lists, Diagnostics diagnostics) {
    return TrajectoryConditions.compile(model(formula), List.of("robot_x"), lists, 60, diagnostics);
  }

  private static List<String> problems(String formula) {
    Diagnostics diagnostics = new Diagnostics();
    var unused =
        TrajectoryConditions.compile(model(formula), List.of("robot_x"), LISTS, 60, diagnostics);
    return diagnostics.all().stream().map(ListSignalsTest::text).toList();
  }

  private static String text(Diagnostic diagnostic) {
    return diagnostic.line() + ": " + diagnostic.message();
  }

  private static TestModel model(String formula) {
    String document =
        """
        <test_model><name>Model</name><description/><input_spec_list>
        <test_element abstract_type="NUMERIC" real_type="double"><name>goal</name><type>TDI</type>
        <user_value_list><value>1.0</value></user_value_list></test_element></input_spec_list>
        <trajectory_condition_spec_list><trajectory_condition name="condition">%s</trajectory_condition>
        </trajectory_condition_spec_list>
        <order_of_combinations>1</order_of_combinations></test_model>
        """
            .formatted(formula.replace("&", "&amp;").replace("<", "&lt;"));
    return TestModelXml.read(
        new ByteArrayInputStream(document.getBytes(StandardCharsets.UTF_8)), "Model.xml");
  }
}
