package org.sitaf.core.activity;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.sitaf.core.activity.ActivityProfile.Sanitizer;
import org.sitaf.core.activity.ros.RosImplementation;
import org.sitaf.core.activity.ros.RosNode.EndKind;
import org.sitaf.core.activity.ros.RosNode.Topic;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.harness.InterfaceTestApplicationGenerator;
import org.sitaf.core.harness.TestApplication;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.GenerationOptions;
import org.sitaf.core.suite.TestCaseGenerator;
import org.sitaf.core.suite.TestSuite;

class RosActivityTest {
  private static final FileTree PACKAGES =
      tree(
          Map.of(
              "geometry_msgs/msg/Twist.msg", "Vector3 linear\nVector3 angular\n",
              "geometry_msgs/msg/Vector3.msg", "float64 x\nfloat64 y\nfloat64 z\n",
              "sensor_msgs/msg/LaserScan.msg", "std_msgs/Header header\nfloat32[] ranges\n",
              "sensor_msgs/msg/Joy.msg", "float32[] axes\nint32[] buttons\n",
              "std_msgs/msg/Header.msg", "string frame_id\n",
              "std_srvs/srv/SetBool.srv", "bool data\n---\nbool success\nstring message\n"));

  private static final String PROFILE =
      """
      name: node
      component:
        language: ros2-python
        sources: src/pilot
        class: pilot.node:Pilot
        parameters: {max_speed: 0.5, names: [a, b]}
      topics:
        /joy: input.joy
        /cmd_vel: output.command
      provided: [{type: std_srvs/srv/SetBool.srv, name: /enable}]
      models: [Model.xml]
      """;

  private static final String CPP_PROFILE =
      PROFILE
          .replace("ros2-python", "ros2-cpp")
          .replace("class: pilot.node:Pilot", "class: pilot::Pilot");

  private static final String CPP_NODE =
      """
      #include "geometry_msgs/msg/twist.hpp"
      #include <sensor_msgs/msg/joy.hpp>
      using Twist = geometry_msgs::msg::Twist;
      class Pilot : public rclcpp::Node {
        Pilot() : Node("pilot") {
          out_ = this->create_publisher<Twist>("cmd_vel", 10);
          in_ = create_subscription<sensor_msgs::msg::Joy>(
              "joy", rclcpp::SensorDataQoS(), std::bind(&Pilot::on_joy, this, _1));
        }
      };
      """;

  private static final String NODE =
      """
      from geometry_msgs.msg import Twist
      from sensor_msgs.msg import (
          Joy,
          LaserScan as Scan,
      )
      class Pilot(Node):
          def __init__(self):
              self.create_publisher(Twist, "cmd_vel", 10)
              self.create_subscription(Joy, "joy", self.on_joy, 10)
              self.create_subscription(Scan, 'scan', self.on_scan, 10)
      """;

  private static final String INPUTS =
      """
      <test_element abstract_type="NUMERIC" real_type="double">
        <name>joy.axes[1]</name><type>TDI</type>
        <user_value_list><value>0.5</value></user_value_list>
      </test_element>
      <test_element abstract_type="NUMERIC" real_type="double">
        <name>publish.joy.rate_hz</name><type>TDI</type>
        <user_value_list><value>20.0</value></user_value_list>
      </test_element>
      <test_element abstract_type="NUMERIC" real_type="int">
        <name>ros.callback_order</name><type>TDSD</type>
        <user_value_list><value>0</value><value>1</value></user_value_list>
      </test_element>
      """;

  private static final String OUTPUTS =
      """
      <test_element abstract_type="NUMERIC" real_type="double">
        <name>command.linear.x</name><type>OUT</type><expected>joy.axes[1]</expected>
      </test_element>
      <test_element abstract_type="NUMERIC" real_type="int">
        <name>command.count</name><type>OUT</type><expected>1</expected>
      </test_element>
      """;

  private static final String CONDITION = "messages[\"command\"].all(m, m.linear.x &lt;= 1.0)";

  private final Map<String, String> files =
      new HashMap<>(
          Map.of(
              "activity.yaml",
              PROFILE,
              "src/pilot/package.xml",
              "<package><name>pilot</name></package>",
              "src/pilot/pilot/node.py",
              NODE,
              "Model.xml",
              model("publish", INPUTS, OUTPUTS)));

  @Test
  void readsTopicsWithTheTypesThatTheSourcesName() {
    Activity activity = Activity.read(tree(files), PACKAGES);

    assertThat(activity.ros()).isNotNull();
    assertThat(activity.ros().node().topics())
        .extracting(Topic::name, Topic::type)
        .containsExactly(
            org.assertj.core.groups.Tuple.tuple("/joy", "sensor_msgs/Joy"),
            org.assertj.core.groups.Tuple.tuple("/cmd_vel", "geometry_msgs/Twist"));
    assertThat(activity.ros().node().topicsWith(EndKind.INPUT)).hasSize(1);
    assertThat(activity.provided()).extracting(p -> p.name()).containsExactly("topics", "std_srvs");
  }

  @Test
  void theGeneratedApplicationCanBeReadWithoutInstalledPackages() {
    Activity activity = Activity.read(tree(files), PACKAGES);
    TestModel model = activity.models().get(0);
    TestSuite suite = TestCaseGenerator.generate(model, GenerationOptions.DEFAULT).suite();
    TestApplication application =
        InterfaceTestApplicationGenerator.generate(activity, model, suite);

    TestApplication read = TestApplication.read(application.files());

    assertThat(read.activity().provided()).isEqualTo(activity.provided());
    String plan = application.harness().text(planPath(application)).orElseThrow();
    assertThat(plan)
        .contains("{\"name\": \"/joy\", \"type\": \"sensor_msgs/msg/Joy\", \"input\": \"joy\"}")
        .contains("\"max_speed\": 0.5")
        .contains("\"names\": [\"a\", \"b\"]")
        .contains("{\"column\": \"joy.axes[1]\", \"root\": \"joy\", \"path\": [\"axes\", 1]}");
    assertThat(application.harness().paths())
        .contains("sitaf_ros_interfaces/geometry_msgs/msg/Vector3.msg");
  }

  @Test
  void reportsAllProblemsOfTopicsWithTheirLines() {
    files.put(
        "activity.yaml",
        PROFILE
            .replace("/joy: input.joy", "/joy: input.joy\n  /odd: input.odd\n  /far: device.lidar")
            .replace("output.command", "outputs.command"));

    assertThat(problems())
        .contains(
            "activity.yaml:11: topics./cmd_vel: 'outputs.command' is not device.NAME, input.NAME,"
                + " output.NAME or world")
        .anyMatch(
            p ->
                p.startsWith("activity.yaml:9: topics./odd: the node's sources do not name")
                    && p.contains(" (they have /"))
        .anyMatch(
            p -> p.startsWith("activity.yaml:10: topics./far: is connected to a device, but"));
  }

  @Test
  void refusesAMessageThatADeviceDoesNotHave() {
    files.put(
        "activity.yaml",
        PROFILE.replace("/joy: input.joy", "/joy: device.lidar") + "world: world/w.world.yaml\n");
    files.put("world/w.world.yaml", "mjcf: w.xml\ndevices:\n  lidar: {kind: laser_scan}\n");

    assertThat(problems())
        .anyMatch(
            p ->
                p.contains("has messages of type sensor_msgs/msg/Joy; what fits a device of kind")
                    && p.contains("sensor_msgs/msg/LaserScan"));
  }

  @Test
  void refusesElementsThatNothingPublishes() {
    files.put(
        "Model.xml",
        model(
            "publish",
            INPUTS.replace("publish.joy.rate_hz", "publish.joystick.rate_hz"),
            OUTPUTS.replace("command.linear.x", "command.linear.w")));

    assertThat(problems())
        .anyMatch(p -> p.contains("publish.joystick.rate_hz: is not publish.NAME"))
        .anyMatch(
            p ->
                p.contains(
                    "command.linear.w: geometry_msgs/Vector3 has no member 'w'; it has x, y, z"));
  }

  @Test
  void readsANodeInCpp() {
    files.put("src/pilot/src/pilot.cpp", CPP_NODE);
    files.put("activity.yaml", CPP_PROFILE);

    Activity activity = Activity.read(tree(files), PACKAGES);

    assertThat(activity.ros().node().isCpp()).isTrue();
    assertThat(activity.ros().node().entry()).isEqualTo("pilot::Pilot");
    assertThat(activity.ros().node().topics())
        .extracting(Topic::type)
        .containsExactly("sensor_msgs/Joy", "geometry_msgs/Twist");
  }

  @Test
  void aNodeInCppMayBeSanitized() {
    files.put("src/pilot/src/pilot.cpp", CPP_NODE);
    files.put("activity.yaml", CPP_PROFILE + "sanitize: [address, undefined]\n");

    assertThat(Activity.read(tree(files), PACKAGES).profile().sanitizers())
        .containsExactly(Sanitizer.ADDRESS, Sanitizer.UNDEFINED);
  }

  @Test
  void refusesSanitizersThatFindNothing() {
    files.put("activity.yaml", PROFILE + "sanitize: [address]\n");
    assertThat(problems()).anyMatch(p -> p.contains("sanitize: is only allowed for components"));

    files.put("src/pilot/src/pilot.cpp", CPP_NODE);
    files.put("activity.yaml", CPP_PROFILE + "sanitize: [thread]\n");
    assertThat(problems()).anyMatch(p -> p.contains("sanitize: thread finds nothing in a ROS 2"));
  }

  @Test
  void refusesEntriesThatAreNotOfItsLanguage() {
    files.put("src/pilot/src/pilot.cpp", CPP_NODE);
    files.put(
        "activity.yaml",
        CPP_PROFILE.replace("class: pilot::Pilot", "class: pilot.node:Pilot\n  packages: [a b]"));

    assertThat(problems())
        .anyMatch(p -> p.contains("'pilot.node:Pilot' is not a C++ class or component"))
        .anyMatch(p -> p.contains("'a b' is no name of pkg-config"));
  }

  @Test
  void refusesAMainThatIsNotThere() {
    files.put("src/pilot/src/pilot.cpp", CPP_NODE);
    files.put("activity.yaml", CPP_PROFILE.replace("class: pilot::Pilot", "main: src/other.cpp"));

    assertThat(problems())
        .anyMatch(p -> p.contains("component.main: 'src/other.cpp' does not exist below"));
  }

  @Test
  void anActivityCanNameTheTypeOfATopic() {
    files.put("src/pilot/pilot/node.py", "class Pilot: pass");
    files.put(
        "activity.yaml",
        PROFILE
            .replace("input.joy", "{with: input.joy, type: sensor_msgs/msg/Joy}")
            .replace("output.command", "{with: [output.command], type: geometry_msgs/Twist}"));

    assertThat(Activity.read(tree(files), PACKAGES).ros().node().topics())
        .extracting(Topic::type)
        .containsExactly("sensor_msgs/Joy", "geometry_msgs/Twist");
  }

  private List<String> problems() {
    InvalidInputException e =
        catchThrowableOfType(
            InvalidInputException.class, () -> Activity.read(tree(files), PACKAGES));
    assertThat(e).isNotNull();
    return e.diagnostics().stream()
        .map(d -> d.file() + ":" + d.line() + ": " + d.element() + ": " + d.message())
        .toList();
  }

  private static String planPath(TestApplication application) {
    return application.harness().paths().stream()
        .filter(path -> path.endsWith("/plan.json"))
        .findFirst()
        .orElseThrow();
  }

  private static String model(String method, String inputs, String outputs) {
    return """
    <test_model>
      <name>Model</name>
      <target interface="topics" method="%s" run_for="1"/>
      <input_spec_list>%s</input_spec_list>
      <output_spec_list>%s</output_spec_list>
      <post_condition_spec_list>
        <post_condition>%s</post_condition>
      </post_condition_spec_list>
      <order_of_combinations>1</order_of_combinations>
    </test_model>
    """
        .formatted(method, inputs, outputs, CONDITION);
  }

  private static FileTree tree(Map<String, String> texts) {
    Map<String, byte[]> files = new HashMap<>();
    texts.forEach((path, text) -> files.put(path, text.getBytes(StandardCharsets.UTF_8)));
    return FileTree.of(files);
  }

  @Test
  void theImplementationOfRosIsKeptWithTheApplication() {
    Activity included = Activity.read(tree(files), PACKAGES);
    Activity activity = included.with(RosImplementation.SYSTEM);
    TestModel model = activity.models().get(0);
    TestSuite suite = TestCaseGenerator.generate(model, GenerationOptions.DEFAULT).suite();
    TestApplication application =
        InterfaceTestApplicationGenerator.generate(activity, model, suite);

    TestApplication read = TestApplication.read(application.files());

    assertThat(read.activity().rosImplementation()).contains(RosImplementation.SYSTEM);
    assertThat(read.files().paths()).isEqualTo(application.files().paths()).contains("ros");
    assertThat(application.harness().text(planPath(application)).orElseThrow())
        .contains("\"installed\": true");
    assertThat(activity.limits().caseWall())
        .as("a case in real time has more of it")
        .isEqualTo(
            included.limits().caseWall().plus(included.limits().caseSimulation().multipliedBy(4)));
    assertThat(
            InterfaceTestApplicationGenerator.generate(included, model, suite)
                .files()
                .content("ros"))
        .isEmpty();
  }
}
