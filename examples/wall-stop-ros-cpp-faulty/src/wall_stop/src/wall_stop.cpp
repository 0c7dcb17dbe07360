// Drives forward and stops before an obstacle.
#include <cmath>
#include <functional>
#include <limits>

#include "geometry_msgs/msg/twist.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_components/register_node_macro.hpp"
#include "sensor_msgs/msg/laser_scan.hpp"
#include "std_msgs/msg/float64.hpp"

namespace wall_stop
{

// Half of the sector ahead that counts, in radians.
constexpr double SECTOR = 0.2;

// Drives with the speed of the last `start` message until something ahead is nearer than `stop_distance`.
class WallStop : public rclcpp::Node
{
public:
  explicit WallStop(const rclcpp::NodeOptions & options)
  : Node("wall_stop", options)
  {
    declare_parameter("stop_distance", 0.5);
    publisher_ = create_publisher<geometry_msgs::msg::Twist>("cmd_vel", 10);
    start_ = create_subscription<std_msgs::msg::Float64>(
      "start", 10, [this](const std_msgs::msg::Float64 & speed) {speed_ = speed.data;});
    scan_ = create_subscription<sensor_msgs::msg::LaserScan>(
      "scan", 10, std::bind(&WallStop::on_scan, this, std::placeholders::_1));
  }

private:
  void on_scan(const sensor_msgs::msg::LaserScan::ConstSharedPtr scan)
  {
    geometry_msgs::msg::Twist command;
    if (ahead(*scan) > get_parameter("stop_distance").as_double()) {
      command.linear.x = speed_;
    }
    publisher_->publish(command);
  }

  // The smallest distance ahead. An infinite one means that there is nothing.
  static double ahead(const sensor_msgs::msg::LaserScan & scan)
  {
    double smallest = std::numeric_limits<double>::infinity();
    for (size_t i = 0; i < scan.ranges.size(); ++i) {
      const double angle = static_cast<double>(i) * scan.angle_increment;
      if (std::abs(angle) <= SECTOR && scan.ranges[i] < smallest) {
        smallest = scan.ranges[i];
      }
    }
    return smallest;
  }

  double speed_ = 0.0;
  rclcpp::Publisher<geometry_msgs::msg::Twist>::SharedPtr publisher_;
  rclcpp::Subscription<std_msgs::msg::Float64>::SharedPtr start_;
  rclcpp::Subscription<sensor_msgs::msg::LaserScan>::SharedPtr scan_;
};

}  // namespace wall_stop

RCLCPP_COMPONENTS_REGISTER_NODE(wall_stop::WallStop)
