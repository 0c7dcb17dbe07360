package org.sitaf.core.activity;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.nio.charset.StandardCharsets;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sitaf.core.description.fault.FaultKind;
import org.sitaf.core.description.fault.FaultName;
import org.sitaf.core.diagnostic.Diagnostic;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.harness.InterfaceTestApplicationGenerator;
import org.sitaf.core.harness.TestApplication;
import org.sitaf.core.suite.ExpectedValue;
import org.sitaf.core.suite.GenerationOptions;
import org.sitaf.core.suite.TestCaseGenerator;
import org.sitaf.core.suite.TestSuite;

/** Faults of devices as inputs of a test model. */
class DeviceFaultsTest {
  private final Map<String, String> files =
      new HashMap<>(
          Map.of(
              "activity.yaml",
              """
              name: robot
              component: {language: java, sources: component/, class: robot.Robot}
              provided: [service.xml]
              world: world/w.world.yaml
              models: [Drive.xml]
              """,
              "service.xml",
              """
              <service_port_type>
                <type_name>RobotService</type_name>
                <method name="Drive" return_type="double"/>
              </service_port_type>
              """,
              "world/w.world.yaml",
              """
              mjcf: w.xml
              devices:
                ir1: {kind: range, sensor: ir1}
                scan: {kind: laser_scan, site: s}
                gps: {kind: pose, site: s}
                eye: {kind: camera, camera: c}
                line: {kind: digital_io}
                bumper: {kind: contact, geom: g}
                base: {kind: differential_drive, left: l, right: r}
                arm: {kind: joint_motor, actuator: a}
              """,
              "world/w.xml",
              "<mujoco/>",
              "component/robot/Robot.java",
              "package robot; public class Robot {}"));

  private Activity read(String inputs, String expected) {
    files.put(
        "Drive.xml",
        """
        <test_model><name>Drive</name>
          <input_spec_list>%s</input_spec_list>
          <output_spec_list>
            <test_element abstract_type="NUMERIC" real_type="double"><name>return</name><type>RETURN</type>
              <expected>%s</expected></test_element>
          </output_spec_list>
          <trajectory_condition_spec_list>
            <trajectory_condition name="stops">always(t &lt; 1.0 -> ir1.range > 0.0)</trajectory_condition>
          </trajectory_condition_spec_list>
          <order_of_combinations>all</order_of_combinations>
        </test_model>
        """
            .formatted(inputs, expected));
    Map<String, byte[]> bytes = new HashMap<>();
    files.forEach((path, text) -> bytes.put(path, text.getBytes(StandardCharsets.UTF_8)));
    return Activity.read(FileTree.of(bytes));
  }

  private static String element(String name, String... values) {
    StringBuilder list = new StringBuilder();
    for (String value : values) {
      list.append("<value>").append(value).append("</value>");
    }
    return "<test_element abstract_type=\"NUMERIC\" real_type=\"double\"><name>"
        + name
        + "</name><type>TDSD</type><user_value_list>"
        + list
        + "</user_value_list></test_element>";
  }

  private String problem(String name, String value) {
    // A part needs its fault.
    String base =
        FaultName.find(name)
            .filter(f -> f.part() != FaultName.Part.FAULT)
            .map(f -> element(f.fault(), String.valueOf(f.kind().neutral())))
            .orElse("");
    InvalidInputException thrown =
        catchThrowableOfType(
            InvalidInputException.class, () -> read(base + element(name, value), "0.0"));
    return thrown == null
        ? ""
        : String.join("; ", thrown.diagnostics().stream().map(Diagnostic::toString).toList());
  }

  private static List<String> expected(Activity activity) {
    TestSuite suite =
        TestCaseGenerator.generate(activity.models().get(0), GenerationOptions.DEFAULT).suite();
    return suite.cases().stream()
        .map(c -> c.expected())
        .flatMap(Collection::stream)
        .map(ExpectedValue::literal)
        .toList();
  }

  @ParameterizedTest
  @CsvSource({
    "fault.ir1.stuck, 1",
    "fault.ir1.range.offset, -0.5",
    "fault.scan.ranges.3.dropout, 1",
    "fault.scan.ranges.dropout, 1",
    "fault.gps.position.noise, 0.1",
    "fault.gps.position.x.delay, 0.1",
    "fault.bumper.offset, 1",
    "fault.bumper.pressed.stuck, 1",
    "fault.line.ignored, 1",
    "fault.base.linear.ignored, 1",
    "fault.base.saturated, 1",
    "fault.arm.velocity.scale, 0",
    "fault.ir1.intermittent, 0.5",
    "fault.ir1.out_of_range.value, 99",
    "fault.ir1.dropout.for, 0.2",
  })
  void aFaultThatFitsIsAccepted(String name, String value) {
    assertThat(problem(name, value)).isEmpty();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "fault.ir1.shaky | 1 | kinds: stuck, dropout",
        "fault.ir1.dropout.value | 1 | must be named fault.DEVICE",
        "fault.sonar.dropout | 1 | w.world.yaml has no device sonar; it has ir1, scan, gps",
        "fault.ir1.ignored | 1 | does not fit ir1, a range; its faults: stuck, dropout, offset",
        "fault.eye.dropout | 1 | a camera, which has no faults",
        "fault.line.offset | 1 | its faults: stuck, dropout, delay, intermittent, ignored",
        "fault.line.saturated | 1 | does not fit line",
        "fault.bumper.pressed.noise | 1 | does not fit bumper",
        "fault.gps.speed.offset | 1 | its fields: position, position.x",
        "fault.base.linear.saturated | 1 | does not fit base",
        "fault.ir1.dropout | 0.5 | the value 0.5 must be 0 or 1",
        "fault.ir1.noise | -1 | must be a standard deviation of 0 or more",
        "fault.ir1.delay | 11 | must be 0 to 10.0 s",
        "fault.ir1.intermittent | 2 | must be a probability from 0 to 1",
        "fault.ir1.dropout.at | -1 | must be 0 s or more",
      })
  void aFaultThatDoesNotFitIsRefused(String name, String value, String message) {
    assertThat(problem(name, value)).contains(name).contains(message);
  }

  @Test
  void aPartWithoutItsFaultHasNoEffect() {
    InvalidInputException thrown =
        catchThrowableOfType(
            InvalidInputException.class, () -> read(element("fault.ir1.dropout.at", "1.0"), "0.0"));
    assertThat(thrown.diagnostics().toString())
        .contains("has no effect without the fault itself; add a test_element fault.ir1.dropout");
  }

  @Test
  void eachNameIsOneVariableAndTimesHaveDefaults() {
    String all =
        element("fault.ir1.dropout", "0", "1")
            + element("fault.ir1.dropout.at", "0.5")
            + element("fault.ir1.dropout.for", "1.5")
            + element("fault.ir1.range.offset", "2");
    assertThat(
            expected(
                read(
                    all,
                    "fault.ir1.dropout == 1 ? fault.ir1.dropout.end + fault.ir1.range.offset :"
                        + " 0.0")))
        .containsExactly("0.0", "4.0");
    assertThat(
            expected(
                read(
                    element("fault.ir1.dropout", "1"),
                    "valid &amp;&amp; valid_fault.ir1.dropout ? fault.ir1.dropout.at : 1.0")))
        .containsExactly("0.0");
    assertThat(
            expected(
                read(
                    element("fault.ir1.dropout", "1") + element("fault.ir1.dropout.at", "3"),
                    "fault.ir1.dropout.end")))
        .containsExactly("Infinity");
  }

  @Test
  void everyLanguageSetsFaultsLikeParameters() throws Exception {
    for (String language : List.of("java", "cpp", "python")) {
      files.put(
          "activity.yaml",
          """
          name: robot
          component: {language: %s, sources: component/, class: %s}
          provided: [service.xml]
          world: world/w.world.yaml
          models: [Drive.xml]
          """
              .formatted(language, language.equals("cpp") ? "robot::Robot" : "robot.Robot"));
      files.put("component/robot.py", "class Robot: pass\n");
      files.put("component/robot.hpp", "namespace robot { class Robot {}; }\n");
      Activity activity =
          read(
              element("fault.gps.position.x.noise", "0.1")
                  + element("fault.gps.position.x.noise.at", "1"),
              "0.0");
      TestSuite suite =
          TestCaseGenerator.generate(activity.models().get(0), GenerationOptions.DEFAULT).suite();
      TestApplication application =
          InterfaceTestApplicationGenerator.generate(activity, activity.models().get(0), suite);
      StringBuilder sources = new StringBuilder();
      for (String path : application.harness().paths()) {
        sources.append(
            new String(application.harness().content(path).orElseThrow(), StandardCharsets.UTF_8));
      }
      assertThat(sources.toString())
          .as(language)
          .contains("\"fault.gps.position.x.noise\"")
          .contains("\"fault.gps.position.x.noise.at\"");
    }
  }

  @Test
  void theNameOfAFaultHasPartsThatDoNotOverlap() {
    FaultName name = FaultName.parse("fault.gps.orientation.w.out_of_range.value");
    assertThat(name)
        .isEqualTo(
            new FaultName("gps", "orientation.w", FaultKind.OUT_OF_RANGE, FaultName.Part.VALUE));
    assertThat(name.fault()).isEqualTo("fault.gps.orientation.w.out_of_range");
    assertThat(name.text()).isEqualTo("fault.gps.orientation.w.out_of_range.value");
    assertThat(FaultName.find("fault")).isEmpty();
    assertThat(FaultName.find("fault..dropout")).isEmpty();
    assertThat(FaultName.find("Distance")).isEmpty();
  }
}
