"""The documents' fragments about ROS 2 nodes belong to nodes that pass."""

import re
import shutil

import pytest
from needs import cpp
from snippets import ROOT, snippet

yaml = pytest.importorskip("yaml", reason="PyYAML is missing")

EXAMPLES = ROOT / "examples"
FOLLOWER = '''
import os
import sys

import rclpy
from geometry_msgs.msg import PoseStamped, Twist, Vector3
from rclpy.node import Node
from rclpy.time import Time
from sensor_msgs.msg import LaserScan
from std_srvs.srv import SetBool
from tf2_ros import Buffer, TransformListener

ROBOT = f"{os.environ['ROBOT']} {os.environ['ROS_DISTRO']}"


class Follower(Node):
    """Drives with the greatest speed when it has a goal, a scan and its pose."""

    def __init__(self):
        super().__init__("follower")
        self.speed = self.declare_parameter("max_speed", 0.1).value
        self.enabled, self.goal = sys.stdin.readline().strip() == "yes", None
        self.commands = self.create_publisher(Twist, "cmd_vel", 10)
        self.create_subscription(PoseStamped, "/goal", self.take, 10)
        self.create_subscription(LaserScan, "/scan", self.drive, 10)
        self.create_service(SetBool, "/enable", self.enable)
        self.poses = Buffer()
        self.listener = TransformListener(self.poses, self)

    def enable(self, request, response):
        self.enabled = response.success = request.data
        return response

    def take(self, goal):
        self.goal = goal

    def drive(self, scan):
        seen = ROBOT == "small jazzy" and self.poses.can_transform("world", "pose", Time())
        if self.enabled and self.goal and seen and scan.header.frame_id == "base_scan":
            self.commands.publish(Twist(linear=Vector3(x=self.speed)))
'''
AVERAGE = """
#include <Eigen/Core>
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/float64.hpp>

namespace my_package {
class Follower : public rclcpp::Node {
 public:
  Follower() : Node("follower") {
    out_ = create_publisher<std_msgs::msg::Float64>("norm", 10);
    timer_ = create_wall_timer(std::chrono::milliseconds(100), [this] {
      std_msgs::msg::Float64 message;
      message.data = Eigen::Vector2d(3, 4).norm();
      out_->publish(message);
    });
  }

 private:
  rclcpp::Publisher<std_msgs::msg::Float64>::SharedPtr out_;
  rclcpp::TimerBase::SharedPtr timer_;
};
}  // namespace my_package
"""


def element(name, kind, real_type, expected="", value=""):
    abstract = {"string": "STRING", "boolean": "BOOLEAN"}.get(real_type, "NUMERIC")
    values = f"<user_value_list><value>{value}</value></user_value_list>" if value else ""
    judged = f"<expected>{expected}</expected>" if expected else ""
    return (
        f'<test_element abstract_type="{abstract}" real_type="{real_type}"><name>{name}</name><type>{kind}</type>'
        f"{values}{judged}</test_element>"
    )


def model(folder, name, target, inputs, outputs):
    (folder / f"{name}.xml").write_text(
        f"<test_model><name>{name}</name><target {target}/><input_spec_list>{''.join(inputs)}</input_spec_list>"
        f"<output_spec_list>{outputs}</output_spec_list><order_of_combinations>1</order_of_combinations></test_model>"
    )


def package(folder, path, text):
    file = folder / "src" / "my_package" / path
    file.parent.mkdir(parents=True)
    (folder / "src" / "my_package" / "package.xml").write_text("<package><name>my_package</name></package>")
    file.write_text(text)


def expect_passed(sitaf, folder, cases):
    run = sitaf("run", folder, "--no-coverage")
    assert run.returncode == 0, run.stdout + run.stderr
    assert run.stdout.count(f"{cases} PASS, 0 FAIL") > 0, run.stdout


def test_an_activity_connects_a_node(sitaf, tmp_path):
    package(tmp_path, "my_package/follower.py", FOLLOWER)
    shutil.copytree(EXAMPLES / "wall-stop-ros" / "world", tmp_path / "world")
    world = tmp_path / "world" / "maze.world.yaml"
    world.write_text(world.read_text().replace("devices:\n", "devices:\n  pose: {kind: pose, site: lidar}\n"))
    (tmp_path / "activity.yaml").write_text(
        f"name: follower\n{snippet('ros2-1-yaml')}world: world/maze.world.yaml\nmodels: [Follow.xml, Enable.xml]\n"
    )
    answer = element("answer", "TDI", "string", value="yes")
    goal = element("goal.pose.position.x", "TDI", "double", value="1.0")
    command = element("command.linear.x", "OUT", "double", expected="0.5")
    model(tmp_path, "Follow", 'interface="topics" method="publish" run_for="1"', [answer, goal], command)
    enable = element("data", "TDI", "boolean", value="true")
    success = element("success", "OUT", "boolean", expected="true")
    model(tmp_path, "Enable", 'interface="std_srvs" method="SetBool"', [answer, enable], success)
    expect_passed(sitaf, tmp_path, 1)


@cpp
def test_an_activity_of_a_node_in_cpp_names_packages(sitaf, tmp_path):
    package(tmp_path, "src/follower.cpp", AVERAGE)
    (tmp_path / "activity.yaml").write_text(
        f"name: follower\n{snippet('ros2-5-yaml')}topics: {{/norm: output.norm}}\nmodels: [Norm.xml]\n"
    )
    norm = element("norm.data", "OUT", "double", expected="5.0")
    model(tmp_path, "Norm", 'interface="topics" method="publish" run_for="1"', [], norm)
    expect_passed(sitaf, tmp_path, 1)


def test_the_calls_of_a_managed_node_are_those_of_an_example(sitaf, tmp_path):
    folder = shutil.copytree(EXAMPLES / "lifecycle-node", tmp_path / "node")
    profile = yaml.safe_load((folder / "activity.yaml").read_text())
    assert yaml.safe_load(snippet("ros2-2-yaml"))["provided"] == profile["provided"]
    file = folder / "LifeCycle.xml"
    text = file.read_text()
    for shown in re.findall(r"<call .*?</call>", snippet("ros2-3-xml"), re.DOTALL):
        name = re.search(r'name="(\w+)"', shown)[1]
        whole = re.search(rf'<call name="{name}".*?</call>', text, re.DOTALL)[0]
        # What the page leaves out is that of the example.
        rest = whole[whole.index("<input_spec_list>") : whole.index("</call>")]
        if name == "Temperature":
            rest = whole[whole.index(">") + 1 : whole.index("</call>")]
        text = text.replace(whole, shown.replace("...", rest))
    file.write_text(text)
    run = sitaf("run", folder, "--no-coverage")
    assert run.returncode == 0, run.stdout + run.stderr
