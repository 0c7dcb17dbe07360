"""C++ nodes that use the API as public packages do: filters of transforms and messages, diagnostics, point clouds."""

import pytest

from sitaf_ros.conversion import to_fields
from tests.cpp_cases import node

pytestmark = pytest.mark.slow
SCAN, STRING, TWIST = "sensor_msgs/msg/LaserScan", "std_msgs/msg/String", "geometry_msgs/msg/Twist"
NODE = r"""
#include <chrono>
#include <memory>

#include "angles/angles.h"
#include "diagnostic_updater/publisher.hpp"
#include "geometry_msgs/msg/point_stamped.hpp"
#include "geometry_msgs/msg/detail/twist__struct.hpp"
#include "message_filters/chain.h"
#include "message_filters/subscriber.h"
#include "message_filters/time_sequencer.h"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp/wait_for_message.hpp"
#include "rclcpp_components/register_node_macro.hpp"
#include "sensor_msgs/image_encodings.hpp"
#include "sensor_msgs/msg/laser_scan.hpp"
#include "sensor_msgs/point_cloud2_iterator.hpp"
#include "std_srvs/srv/trigger.hpp"
#include "tf2_ros/create_timer_ros.h"
#include "tf2_ros/message_filter.h"
#include "tf2_ros/transform_listener.h"
#include "tf2_sensor_msgs/tf2_sensor_msgs.hpp"

using namespace std::chrono_literals;
using sensor_msgs::msg::LaserScan;
using std::placeholders::_1;

namespace probe {

class Node : public rclcpp::Node
{
public:
  explicit Node(const rclcpp::NodeOptions & options)
  : rclcpp::Node("probe", options), buffer_(get_clock()), listener_(buffer_, this), updater_(this),
    odometry_("odom", updater_, diagnostic_updater::FrequencyStatusParam(&least_, &most_, 0.1, 5),
      diagnostic_updater::TimeStampStatusParam(-1, 5), get_clock())
  {
    updater_.setHardwareID("base");
    buffer_.setCreateTimerInterface(std::make_shared<tf2_ros::CreateTimerROS>(
        get_node_base_interface(), get_node_timers_interface()));
    scans_.subscribe(this, "scan", rmw_qos_profile_sensor_data);
    filter_ = std::make_unique<tf2_ros::MessageFilter<LaserScan>>(
      scans_, buffer_, "odom", 3, get_node_logging_interface(), get_node_clock_interface(), 1s);
    filter_->registerCallback(std::bind(&Node::scan, this, _1));
    filter_->registerFailureCallback([this](const LaserScan::ConstSharedPtr & m, tf2_ros::FilterFailureReason reason) {
        RCLCPP_INFO(get_logger(), "dropped %.0f %d", m->angle_min, static_cast<int>(reason));
      });
    ordered_.subscribe(this, "ordered");
    sequencer_ = std::make_shared<message_filters::TimeSequencer<LaserScan>>(
      rclcpp::Duration(200ms), rclcpp::Duration(10ms), 10, this);
    chain_.addFilter(sequencer_);
    chain_.connectInput(ordered_);
    chain_.registerCallback([this](const LaserScan::ConstSharedPtr & m) {
        RCLCPP_INFO(get_logger(), "in order %.0f", m->angle_min);
      });
    service_ = create_service<std_srvs::srv::Trigger>(
      "compute",
      [this](const std_srvs::srv::Trigger::Request::SharedPtr, std_srvs::srv::Trigger::Response::SharedPtr r) {
        r->message = compute();
        r->success = true;
      });
    timer_ = rclcpp::create_timer(
      get_node_base_interface(), get_node_timers_interface(), get_clock(), rclcpp::Duration(100ms), [this] {
        odometry_.tick(now());
      });
  }

private:
  void scan(const LaserScan::ConstSharedPtr & m) {RCLCPP_INFO(get_logger(), "scan %.0f", m->angle_min);}
  std::string compute()
  {
    auto point = geometry_msgs::build<geometry_msgs::msg::Point>().x(1).y(2).z(3);
    sensor_msgs::msg::PointCloud2 cloud;
    cloud.height = 1;
    sensor_msgs::PointCloud2Modifier modifier(cloud);
    modifier.setPointCloud2FieldsByString(2, "xyz", "rgb");
    modifier.resize(2);
    sensor_msgs::PointCloud2Iterator<float> x(cloud, "x"), z(cloud, "z");
    sensor_msgs::PointCloud2Iterator<std::uint8_t> red(cloud, "r");
    for (; x != x.end(); ++x, ++z, ++red) {
      *x = static_cast<float>(point.x);
      *z = static_cast<float>(point.z);
      *red = 200;
    }
    geometry_msgs::msg::TransformStamped moved;
    moved.transform.translation.x = 10;
    moved.transform.rotation.w = 1;
    tf2::doTransform(cloud, cloud, moved);
    double sum = 0;
    for (sensor_msgs::PointCloud2ConstIterator<float> it(cloud, "x"); it != it.end(); ++it) {
      sum += *it;
    }
    char text[100];
    std::snprintf(
      text, sizeof text, "%u %.0f %.2f %d %zu", cloud.point_step, sum, angles::normalize_angle(7.0),
      sensor_msgs::image_encodings::numChannels("16UC3"),
      get_service_names_and_types_by_node("probe", "/").count("/compute"));
    return text;
  }

  double least_ = 9, most_ = 11;
  tf2_ros::Buffer buffer_;
  tf2_ros::TransformListener listener_;
  diagnostic_updater::Updater updater_;
  diagnostic_updater::TopicDiagnostic odometry_;
  message_filters::Subscriber<LaserScan> scans_, ordered_;
  std::unique_ptr<tf2_ros::MessageFilter<LaserScan>> filter_;
  std::shared_ptr<message_filters::TimeSequencer<LaserScan>> sequencer_;
  message_filters::Chain<LaserScan> chain_;
  rclcpp::Service<std_srvs::srv::Trigger>::SharedPtr service_;
  rclcpp::TimerBase::SharedPtr timer_;
};

}  // namespace probe

RCLCPP_COMPONENTS_REGISTER_NODE(probe::Node)
"""


def at(seconds):
    return {"sec": int(1_700_000_000 + seconds), "nanosec": round((seconds % 1) * 1e9)}


def transform(seconds):
    header = {"frame_id": "odom", "stamp": at(seconds)}
    return {"transforms": [{"header": header, "child_frame_id": "laser", "transform": {"rotation": {"w": 1.0}}}]}


def drive(case):
    system = case.system
    diagnostics = []
    system.subscribe(
        "/diagnostics", "diagnostic_msgs/msg/DiagnosticArray", lambda m, t: diagnostics.append(to_fields(m))
    )
    case.run(0.1)

    def scan(topic, number, seconds, frame="laser"):
        header = {"frame_id": frame, "stamp": at(seconds)}
        system.publish(topic, SCAN, {"header": header, "angle_min": float(number)})

    # The first waits for the transform; the second has no frame; the third waits in vain, for a second.
    scan("/scan", 1, 0.3)
    scan("/scan", 2, 0.3, frame="")
    scan("/scan", 3, 50)
    system.publish("/tf", "tf2_msgs/msg/TFMessage", transform(0.2))
    case.run(0.2)
    before = list(case.texts)
    system.publish("/tf", "tf2_msgs/msg/TFMessage", transform(0.4))
    scan("/ordered", 8, 0.6)
    scan("/ordered", 7, 0.5)
    case.run(1.5)
    for number in range(10, 15):
        scan("/scan", number, 90)
    case.run(1.6)
    answer = system.call_service("/compute", "std_srvs/srv/Trigger", {})
    case.run(2)
    return before, case.texts, answer.response.message, diagnostics


def test_a_node_uses_filters_diagnostics_and_point_clouds_as_in_ros(tmp_path):
    before, texts, computed, diagnostics = node(tmp_path, NODE, drive, entry="probe::Node")
    assert before == ["dropped 2 2"]
    assert texts[1:6] == ["scan 1", "in order 7", "in order 8", "dropped 3 3", "dropped 10 4"]
    assert computed == "32 22 0.72 3 1"
    levels = [[(s["name"], s["level"], s["message"]) for s in one["status"]] for one in diagnostics]
    assert levels[0] == [("probe: odom topic status", 0, "Node starting up")]
    assert levels[-1][0][1:] == (0, "Desired frequency met; Timestamps are reasonable.")


KEYBOARD = r"""
#include <sys/select.h>
#include <termios.h>
#include <unistd.h>

#include <cstdio>
#include <iostream>
#include <string>

#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = rclcpp::Node::make_shared("keyboard");
  auto publisher = node->create_publisher<std_msgs::msg::String>("keys", 10);
  const auto say = [&](const std::string & text) {
      std_msgs::msg::String message;
      message.data = text;
      publisher->publish(message);
    };
  std::string name;
  std::getline(std::cin, name);
  say("name " + name);
  char line[20];
  say(std::string("line ") + (std::fgets(line, sizeof line, stdin) ? line : "none"));
  termios raw;
  if (tcgetattr(fileno(stdin), &raw) < 0) {
    throw std::runtime_error("Failed to get terminal settings");
  }
  raw.c_lflag &= ~(ICANON | ECHO);
  tcsetattr(STDIN_FILENO, TCSANOW, &raw);
  char key = 0;
  say(read(0, &key, 1) == 1 ? std::string("key ") + key : "no key");
  read(0, &key, 1);
  fd_set reads;
  FD_ZERO(&reads);
  FD_SET(0, &reads);
  timeval timeout{0, 500000};
  say("select " + std::to_string(select(1, &reads, nullptr, nullptr, &timeout)));
  read(0, &key, 1);
  say("never");
  return 0;
}
"""


def test_a_terminal_gives_the_lines_of_the_case(tmp_path):
    def script(case):
        got = case.heard("/keys", STRING)
        case.run(2)
        return got, case.system.report().warnings

    got, warnings = node(tmp_path, KEYBOARD, script, entry="probe.cpp", stdin=["Ada", "two", "w"])
    assert warnings == ()
    assert [text for _, text in got] == ["name Ada", "line two\n", "key w", "select 0"]
    assert [time for time, _ in got] == pytest.approx([0, 0, 0, 0.5])
    nothing, (warning,) = node(tmp_path, KEYBOARD, script, entry="probe.cpp")
    assert nothing == []
    assert "stdin in activity.yaml" in warning
