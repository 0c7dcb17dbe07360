package org.sitaf.core.beginning.node;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.beginning.Proposal;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.sequence.SequenceCall;

class NewNodeActivityTest {
  private static final String MANIFEST = "<package><name>follower</name></package>";
  private static final FileTree INSTALLED =
      tree(
          Map.of(
              "std_msgs/msg/Float64.msg", "float64 data\n",
              "std_msgs/msg/Float64MultiArray.msg", "float64[] data\n",
              "lifecycle_msgs/msg/State.msg", "uint8 id\nstring label\n",
              "lifecycle_msgs/msg/Transition.msg", "uint8 id\nstring label\n",
              "lifecycle_msgs/srv/ChangeState.srv",
                  "lifecycle_msgs/Transition transition\n---\nbool success\n",
              "lifecycle_msgs/srv/GetState.srv", "---\nlifecycle_msgs/State current_state\n",
              "std_srvs/srv/SetBool.srv", "bool data\n---\nbool success\nstring message\n",
              "demo/action/Turn.action", "float64 angle\n---\nbool done\n---\nfloat64 left\n"));
  private static final String NODE =
      """
      import rclpy
      from rclpy.node import Node
      from rclpy.action import ActionServer
      from std_msgs.msg import Float64, Float64MultiArray as Many
      from std_srvs.srv import SetBool
      from demo.action import Turn
      from .planner import Planner

      class Follower(Node):
          def __init__(self, name='follower', **options):
              super().__init__(name, **options)
              self.declare_parameter('max_speed', 1.0)
              self.out = self.create_publisher(Float64, '/robot/cmd', 10)
              self.create_subscription(msg_type=Many, topic='goal', callback=print, qos_profile=10)
              self.create_publisher(Float64, self.name, 10)
              self.create_publisher(Float64, '~/state', 10)
              self.create_service(SetBool, 'enable', print)
              self.server = ActionServer(self, Turn, 'turn', print)

      class Helper(Node):
          def __init__(self, other):
              pass
      """;
  private static final String PLANNER =
      """
      from std_msgs.msg import Float64
      def plan(node):
          node.create_subscription(Float64, 'robot/cmd', print, 10)
          node.declare_parameter("horizon")
      """;

  private static FileTree tree(Map<String, String> files) {
    Map<String, byte[]> contents = new HashMap<>();
    files.forEach((path, text) -> contents.put(path, text.getBytes(StandardCharsets.UTF_8)));
    return FileTree.of(contents);
  }

  private static FileTree python(Map<String, String> more) {
    Map<String, String> files = new HashMap<>(more);
    files.put("package.xml", MANIFEST);
    files.putIfAbsent("follower/node.py", NODE);
    files.put("follower/planner.py", PLANNER);
    return tree(files);
  }

  private static Proposal propose(FileTree files, @Nullable String entry) {
    NodePackage given = NodePackage.of(files, "follower", null);
    return new NewNodeActivity("a", given, entry, tree(Map.of()), INSTALLED).propose();
  }

  @Test
  void takesTopicsServicesActionsAndParametersFromTheSources() {
    Proposal proposal = propose(python(Map.of()), null);

    assertThat(proposal.files().text("activity.yaml").orElseThrow())
        .contains(
            "  language: ros2-python\n  sources: src/follower\n"
                + "  class: follower.node:Follower\n",
            "declares: horizon, max_speed.",
            "topics:\n  /goal: input.goal\n  /robot/cmd: [input.robot_cmd,"
                + " output.robot_cmd_output]\n",
            "  - {type: std_srvs/srv/SetBool.srv, name: /enable}\n",
            "  - {type: demo/action/Turn.action, name: /turn}\n");
    assertThat(Activity.read(proposal.files(), INSTALLED).models())
        .extracting(TestModel::name)
        .containsExactlyInAnyOrder("Topics", "demo_Turn", "std_srvs_SetBool");
    assertThat(proposal.files().text("Topics.xml").orElseThrow())
        .contains("<name>goal.data</name>", "<value>[0.0, 1.0, 2.0]</value>")
        .contains("<name>robot_cmd_output.count</name>", "run_for=\"1.0\"");
    assertThat(proposal.notes())
        .containsExactly(
            "~/state depends on the name of the node; add its full name to topics",
            "src/follower/follower/node.py creates 1 topics, services or actions whose names or"
                + " types are no literals; the notes of a run name them");
    assertThat(proposal.files().text("src/follower/follower/node.py")).contains(NODE);
  }

  @Test
  void programOfSetupIsPreferredAndSeveralAreNamed() {
    String one = "entry_points={'console_scripts': ['follow = ' 'follower.node:main']}";
    assertThat(
            propose(python(Map.of("setup.py", one)), null)
                .files()
                .text("activity.yaml")
                .orElseThrow())
        .contains("  main: follower.node:main\n");
    FileTree two = python(Map.of("setup.py", one + "#'plan = follower.planner:main'"));
    assertThatThrownBy(() -> propose(two, null))
        .isInstanceOfSatisfying(
            SeveralNodesException.class,
            e ->
                assertThat(e.nodes())
                    .containsExactly("follower.node:main", "follower.planner:main"));
    assertThat(propose(two, "follower.planner:main").files().text("activity.yaml").orElseThrow())
        .contains("  /robot/cmd: input.robot_cmd\n")
        .doesNotContain("goal");
    assertThatThrownBy(() -> propose(two, "follower.other:main"))
        .hasMessageContaining("class follower.other:main: error: is not in the package; it has");
  }

  @Test
  void readsImportsAndProgramsThatAreSplitOverLines() {
    FileTree files =
        python(
            Map.of(
                "setup.py",
                "'console_scripts': [\n 'follow = '\n 'follower.'\n 'program:main']",
                "follower/program.py",
                "import rclpy\nfrom follower.node \\\n  import Follower\nfrom . import (\n  planner,\n)\n"
                    + "def main(): pass\ndef other(): pass\n"));

    String profile = propose(files, null).files().text("activity.yaml").orElseThrow();
    assertThat(profile).contains("  main: follower.program:main\n", "/goal: input.goal", "horizon");
    assertThat(propose(files, "follower.program:other").files().text("activity.yaml").orElseThrow())
        .contains("  main: follower.program:other\n");
  }

  @Test
  void aPackageInPythonThatComesAlongIsALibrary() {
    FileTree siblings =
        tree(Map.of("nav_utils/package.xml", "", "nav_utils/nav_utils/a.py", "A = 1"));
    NodePackage given = NodePackage.of(python(Map.of()), "follower", null);

    FileTree files = new NewNodeActivity("a", given, null, siblings, INSTALLED).propose().files();

    assertThat(files.text("src/nav_utils/nav_utils/a.py")).contains("A = 1");
    assertThat(files.text("activity.yaml").orElseThrow()).contains("libraries: [src/nav_utils]\n");
    assertThat(Activity.read(files, INSTALLED).profile().libraries())
        .containsExactly("src/nav_utils");
  }

  @Test
  void namesAreInTheNamespaceOfTheNode() {
    String node = NODE.replace("(name, **options)", "(name, namespace='/arm')");

    assertThat(
            propose(python(Map.of("follower/node.py", node)), null)
                .files()
                .text("activity.yaml")
                .orElseThrow())
        .contains("  /arm/goal: input.arm_goal\n", "  /robot/cmd: [", "name: /arm/enable}");
  }

  @Test
  void aLifecycleNodeMayGetItsNameWhereItIsMade() {
    String node =
        """
        import rclpy
        from rclpy.lifecycle import (
            Node, Publisher)
        class Talker(Node):
            def __init__(self, name, **kwargs):
                super().__init__(name, **kwargs)
        def main():
            talker = Talker('lc_talker')
        """;
    Map<String, String> files =
        Map.of("follower/node.py", node, "setup.py", "'talk = follower.node:main'");

    assertThat(propose(python(files), null).files().text("activity.yaml").orElseThrow())
        .contains("name: /lc_talker/change_state}", "models: [LifeCycle.xml");
  }

  @Test
  void doesNotStubAServiceThatTheNodeItselfAnswers() {
    String node = NODE + "        self.create_client(SetBool, 'enable')\n";

    assertThat(
            propose(python(Map.of("follower/node.py", node)), "follower.node:Follower")
                .files()
                .text("activity.yaml")
                .orElseThrow())
        .contains("name: /enable}", "required: []\n");
  }

  @Test
  void anActionOfTheActivityUsesInstalledMessages() {
    FileTree siblings =
        tree(Map.of("robot_msgs/action/Go.action", "std_msgs/Float64 goal\n---\nbool done\n---\n"));
    String node =
        NODE.replace("from demo.action import Turn", "from robot_msgs.action import Go as Turn");
    NodePackage given = NodePackage.of(python(Map.of("follower/node.py", node)), "follower", null);

    Proposal proposal = new NewNodeActivity("a", given, null, siblings, INSTALLED).propose();

    assertThat(proposal.files().text("robot_msgs_Go.xml").orElseThrow())
        .contains("<name>goal.data</name>");
  }

  @Test
  void readsPackagesInCpp() {
    String header =
        """
        #include <std_msgs/msg/float64.hpp>
        struct Limits { std::string topic; };
        message_filters::Subscriber<std_msgs::msg::Float64> limit_;
        """;
    String node =
        """
        #include "follower/limits.hpp"
        #include <rclcpp/rclcpp.hpp>
        #include <rclcpp_action/rclcpp_action.hpp>
        using Turn = demo::action::Turn;
        using std_msgs::msg::Float64;
        namespace follower {
        class Follower : public rclcpp::Node {
          explicit Follower(const rclcpp::NodeOptions& o) : Node("follower", o) {
            declare_parameter<double>("max_speed", 1.0);
            imu_ = std::make_shared<message_filters::Subscriber<std_msgs::msg::Float64>>(node, "imu");
            limit_.subscribe(this, "limit", rmw_qos_profile_default);
            pub_ = create_publisher<Float64>("cmd", 10);
            server_ = rclcpp_action::create_server<Turn>(
                get_node_base_interface(), get_node_clock_interface(),
                get_node_logging_interface(), get_node_waitables_interface(), "turn", a, b, c);
          }
        };
        }
        RCLCPP_COMPONENTS_REGISTER_NODE(follower::Follower)
        """;
    FileTree files =
        tree(
            Map.of(
                "package.xml",
                MANIFEST,
                "CMakeLists.txt",
                "project(follower)",
                "include/follower/limits.hpp",
                header,
                "src/limits.cpp",
                "void f() { create_client<std_srvs::srv::SetBool>(\"stop\"); }",
                "src/other.cpp",
                "create_publisher<std_msgs::msg::Float64>(\"other\", 1);",
                "src/node.cpp",
                node));

    String profile = propose(files, null).files().text("activity.yaml").orElseThrow();

    assertThat(profile)
        .contains(
            "language: ros2-cpp",
            "class: follower::Follower",
            "declares: max_speed.",
            "topics:\n  /cmd: output.cmd\n  /imu: input.imu\n  /limit: input.limit\nprovided: \n  - {type: demo/action/Turn.action, name:"
                + " /turn}\n",
            "required: \n  - {type: std_srvs/srv/SetBool.srv, name: /stop}\n");
  }

  @Test
  void messagesOfPackagesNextToItComeAlong() {
    String node = NODE.replace("std_msgs.msg import Float64, ", "own_msgs.msg import Float64, ");
    NodePackage given =
        NodePackage.of(
            python(Map.of("follower/node.py", node.replace("Float64MultiArray as", "Cell as"))),
            "follower",
            null);
    FileTree siblings =
        tree(
            Map.of(
                "own_msgs/msg/Float64.msg", "float64 data\n",
                "own_msgs/msg/Cell.msg", "base_msgs/Number n\n",
                "base_msgs/msg/Number.msg", "int32 n\n",
                "other_msgs/msg/Number.msg", "int32 n\n"));

    FileTree files = new NewNodeActivity("a", given, null, siblings, INSTALLED).propose().files();

    assertThat(files.paths())
        .contains("src/own_msgs/msg/Cell.msg", "src/base_msgs/msg/Number.msg")
        .doesNotContain("src/other_msgs/msg/Number.msg");
    assertThat(files.text("activity.yaml").orElseThrow())
        .contains("/robot/cmd: {with: [input.robot_cmd, output.robot_cmd_output], type: ");
  }

  @Test
  void aLifecycleNodeGetsAModelOfItsTransitions() {
    String python =
        """
        from rclpy.lifecycle import LifecycleNode
        from std_msgs.msg import Float64
        class Heater(LifecycleNode):
            def __init__(self):
                super().__init__("heater")
                self.create_subscription(Float64, 'target', print, 10)
        """;
    String cpp =
        """
        #include <rclcpp/rclcpp.hpp>
        #include <std_msgs/msg/float64.hpp>
        class Heater : public rclcpp_lifecycle::LifecycleNode {
          Heater() : LifecycleNode("heater") {
            sub_ = create_subscription<std_msgs::msg::Float64>("target", 10, f);
          }
        };
        RCLCPP_COMPONENTS_REGISTER_NODE(Heater)
        """;
    for (FileTree node :
        List.of(
            tree(Map.of("package.xml", MANIFEST, "follower/node.py", "import rclpy\n" + python)),
            tree(Map.of("package.xml", MANIFEST, "src/heater.cpp", cpp)))) {
      FileTree files = propose(node, null).files();

      assertThat(files.text("activity.yaml").orElseThrow())
          .contains(
              "  - {type: lifecycle_msgs/srv/ChangeState.srv, name: /heater/change_state}\n"
                  + "  - {type: lifecycle_msgs/srv/GetState.srv, name: /heater/get_state}\n");
      Activity activity = Activity.read(files, INSTALLED);
      assertThat(activity.warnings()).isEmpty();
      assertThat(activity.models())
          .extracting(TestModel::name)
          .containsExactlyInAnyOrder("LifeCycle", "Topics");
      TestModel model =
          activity.models().stream().filter(m -> m.sequence() != null).findFirst().orElseThrow();
      assertThat(Objects.requireNonNull(model.sequence()).calls())
          .extracting(SequenceCall::name)
          .containsExactly("Configure", "Activate", "Deactivate", "Cleanup", "State", "target");
    }
  }

  /** Names in sources are any text. */
  @Test
  void namesRemainSingleValuesOfTheProfile() {
    String node = NODE.replace("'enable'", "\"50%d}, world: {x\"");
    FileTree named = propose(python(Map.of("follower/node.py", node)), null).files();
    assertThat(named.text("activity.yaml").orElseThrow())
        .contains("SetBool.srv, name: '/50%d}, world: {x'}\n");
    assertThat(Activity.read(named, INSTALLED).world()).isNull();
    FileTree percent = python(Map.of("follower/%n.py", NODE, "follower/node.py", ""));
    assertThatThrownBy(() -> propose(percent, null))
        .isInstanceOf(InvalidInputException.class)
        .hasMessageContaining("'follower.%n:Follower' is not a class");
    FileTree deep = python(Map.of("a/".repeat(48) + "notes.txt", ""));
    assertThatThrownBy(() -> propose(deep, null))
        .isInstanceOf(InvalidInputException.class)
        .hasMessageContaining("nested more than 50 folders deep");
  }

  @Test
  void refusesWhatIsNoPackageWithANode() {
    assertThatThrownBy(() -> NodePackage.of(tree(Map.of()), "x/y", null))
        .hasMessageContaining("x/y: error: has no package.xml; name the folder of a ROS 2 package");
    FileTree empty = tree(Map.of("package.xml", MANIFEST));
    assertThatThrownBy(() -> NodePackage.of(empty, "x", null))
        .hasMessageContaining("x: error: has no source that uses rclpy or rclcpp");
    assertThatThrownBy(() -> NodePackage.of(python(Map.of()), "x", true))
        .hasMessageContaining("x: error: has no C++ source that uses rclcpp");
    FileTree both = python(Map.of("src/a.cpp", "#include <rclcpp/rclcpp.hpp>"));
    assertThatThrownBy(() -> NodePackage.of(both, "x", null))
        .hasMessageContaining("choose the language python or cpp");
    FileTree library = python(Map.of("follower/node.py", "import rclpy\n"));
    assertThatThrownBy(() -> propose(library, null))
        .hasMessageContaining(
            "follower: error: has neither a console script in setup.py, nor a script");
  }
}
