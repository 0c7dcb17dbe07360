// Publishes the mean of the ranges of a scan that lie between its limits.
#include <cstddef>
#include <functional>

#include "rclcpp/rclcpp.hpp"
#include "rclcpp_components/register_node_macro.hpp"
#include "sensor_msgs/msg/laser_scan.hpp"
#include "std_msgs/msg/float64.hpp"

namespace mean_range
{

// Publishes nothing for a scan without a valid range.
class MeanRange : public rclcpp::Node
{
public:
  explicit MeanRange(const rclcpp::NodeOptions & options)
  : Node("mean_range", options)
  {
    publisher_ = create_publisher<std_msgs::msg::Float64>("mean_range", 10);
    scan_ = create_subscription<sensor_msgs::msg::LaserScan>(
      "scan", 10, std::bind(&MeanRange::on_scan, this, std::placeholders::_1));
  }

private:
  void on_scan(const sensor_msgs::msg::LaserScan::ConstSharedPtr scan)
  {
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i <= scan->ranges.size(); ++i) {
      const float range = scan->ranges[i];
      if (range >= scan->range_min && range <= scan->range_max) {
        sum += range;
        ++count;
      }
    }
    if (count > 0) {
      std_msgs::msg::Float64 mean;
      mean.data = sum / static_cast<double>(count);
      publisher_->publish(mean);
    }
  }

  rclcpp::Publisher<std_msgs::msg::Float64>::SharedPtr publisher_;
  rclcpp::Subscription<sensor_msgs::msg::LaserScan>::SharedPtr scan_;
};

}  // namespace mean_range

RCLCPP_COMPONENTS_REGISTER_NODE(mean_range::MeanRange)
