package org.sitaf.core.activity;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.sitaf.core.diagnostic.Diagnostic;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.harness.InterfaceTestApplicationGenerator;
import org.sitaf.core.harness.TestApplication;
import org.sitaf.core.suite.GenerationOptions;
import org.sitaf.core.suite.TestCaseGenerator;

/** Trajectory conditions over output data ports. */
class PortConditionsTest {
  private final Map<String, String> files =
      new HashMap<>(
          Map.of(
              "activity.yaml",
              """
              name: arm
              component:
                language: java
                sources: component/
                class: robot.Arm
                profile: arm.xml
              provided: [service.xml]
              world: world/room.world.yaml
              models: [Limit.xml]
              """,
              "world/room.world.yaml",
              """
              mjcf: room.xml
              devices:
                encoder: {kind: joint_encoder, joint: elbow}
              observations:
                robot_x: {device: encoder, field: position, unit: rad}
              """,
              "world/room.xml",
              "<mujoco/>",
              "service.xml",
              """
              <service_port_type>
                <type_name>ArmService</type_name>
                <method name="Limit" return_type="void">
                  <param index="1"><name>most</name><type>double</type></param>
                </method>
              </service_port_type>
              """,
              "arm.xml",
              """
              <component_profile>
                <name>Arm</name>
                <ports>
                  <data_port><name>state</name><data_type>ArmState</data_type><usage>output</usage>
                    <reference>state.xml</reference></data_port>
                  <data_port><name>label</name><data_type>string</data_type><usage>output</usage></data_port>
                  <data_port><name>speed</name><data_type>double</data_type><usage>output</usage></data_port>
                </ports>
              </component_profile>
              """,
              "state.xml",
              """
              <data_type>
                <struct name="ArmState"><item type="double">angle</item><item type="int">swings</item></struct>
              </data_type>
              """,
              "Limit.xml",
              """
              <test_model><name>Limit</name>
                <target interface="ArmService" method="Limit" run_for="1"/>
                <input_spec_list>
                  <test_element abstract_type="NUMERIC" real_type="double"><name>most</name><type>TDI</type>
                    <user_value_list><value>4</value></user_value_list></test_element>
                </input_spec_list>
                <output_spec_list/>
                <trajectory_condition_spec_list>
                  <trajectory_condition name="c">always(state.angle &lt;= speed)</trajectory_condition>
                </trajectory_condition_spec_list>
                <order_of_combinations>1</order_of_combinations>
              </test_model>
              """,
              "component/robot/Arm.java",
              "package robot; public class Arm {}"));

  private Activity read() {
    Map<String, byte[]> bytes = new HashMap<>();
    files.forEach((path, text) -> bytes.put(path, text.getBytes(StandardCharsets.UTF_8)));
    return Activity.read(FileTree.of(bytes));
  }

  private List<String> problems() {
    return catchThrowableOfType(InvalidInputException.class, this::read).diagnostics().stream()
        .map(Diagnostic::toString)
        .toList();
  }

  private void replace(String path, String from, String to) {
    assertThat(files.get(path)).contains(from);
    files.put(path, files.get(path).replace(from, to));
  }

  private String driver() {
    Activity activity = read();
    TestApplication application =
        InterfaceTestApplicationGenerator.generate(
            activity,
            activity.models().get(0),
            TestCaseGenerator.generate(activity.models().get(0), GenerationOptions.DEFAULT)
                .suite());
    return application.files().paths().stream()
        .filter(p -> p.endsWith("/TestDriver.java"))
        .map(p -> new String(application.files().content(p).orElseThrow(), StandardCharsets.UTF_8))
        .findFirst()
        .orElseThrow();
  }

  @Test
  void theDriverWatchesThePortsThatConditionsUse() {
    assertThat(driver())
        .contains("watch(\"state.angle\", () -> dataPort(component, \"state\"));")
        .contains("watch(\"speed\", () -> dataPort(component, \"speed\"));")
        .doesNotContain("swings");
    replace("Limit.xml", "state.angle &lt;= speed", "robot_x &lt;= 1.0");
    assertThat(driver()).doesNotContain(" watch(");
  }

  @Test
  void aPortThatIsNoNumberIsRefusedWithTheSignalsThatExist() {
    replace("Limit.xml", "state.angle &lt;= speed", "label == \"a\"");
    assertThat(problems())
        .singleElement()
        .asString()
        .contains(
            "Limit.xml",
            "label",
            "encoder.position, encoder.velocity, robot_x, speed, state.angle, state.swings, t");
    replace("Limit.xml", "label", "state.label");
    assertThat(problems()).singleElement().asString().contains("label");
  }

  @Test
  void aPortWithTheNameOfAnObservationOrAnInputIsAmbiguous() {
    replace("arm.xml", "<name>speed</name>", "<name>robot_x</name>");
    replace("Limit.xml", "speed", "robot_x");
    assertThat(problems()).singleElement().asString().contains("'robot_x' is two signals");
    replace("arm.xml", "<name>robot_x</name>", "<name>most</name>");
    replace("Limit.xml", "robot_x", "most");
    assertThat(problems()).singleElement().asString().contains("'most' is two signals");
  }
}
