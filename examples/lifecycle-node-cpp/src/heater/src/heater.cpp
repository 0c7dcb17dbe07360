#include <memory>
#include <optional>
#include <rclcpp/rclcpp.hpp>
#include <rclcpp_lifecycle/lifecycle_node.hpp>
#include <rclcpp_lifecycle/lifecycle_publisher.hpp>
#include <std_msgs/msg/bool.hpp>
#include <std_msgs/msg/float64.hpp>

namespace heater {

/** Switches a heater by a thermostat while it is active. The target belongs to a configuration. */
class Heater : public rclcpp_lifecycle::LifecycleNode {
public:
  using Result = rclcpp_lifecycle::node_interfaces::LifecycleNodeInterface::CallbackReturn;

  Heater() : rclcpp_lifecycle::LifecycleNode("heater") {
    declare_parameter("target", 20.0);
    target_subscription_ = create_subscription<std_msgs::msg::Float64>(
        "target", 10, [this](const std_msgs::msg::Float64 &message) {
          if (target_) {
            target_ = message.data;
          }
        });
    temperature_subscription_ = create_subscription<std_msgs::msg::Float64>(
        "temperature", 10, [this](const std_msgs::msg::Float64 &message) {
          if (commands_ && commands_->is_activated()) {
            std_msgs::msg::Bool command;
            command.data = message.data < *target_;
            commands_->publish(command);
          }
        });
  }

  Result on_configure(const rclcpp_lifecycle::State &) override {
    target_ = get_parameter("target").as_double();
    commands_ = create_publisher<std_msgs::msg::Bool>("heat", 10);
    return Result::SUCCESS;
  }

  Result on_activate(const rclcpp_lifecycle::State &) override {
    commands_->on_activate();
    return Result::SUCCESS;
  }

  Result on_deactivate(const rclcpp_lifecycle::State &) override {
    commands_->on_deactivate();
    return Result::SUCCESS;
  }

  Result on_cleanup(const rclcpp_lifecycle::State &) override {
    commands_.reset();
    target_.reset();
    return Result::SUCCESS;
  }

private:
  std::optional<double> target_;
  rclcpp::Subscription<std_msgs::msg::Float64>::SharedPtr target_subscription_;
  rclcpp::Subscription<std_msgs::msg::Float64>::SharedPtr temperature_subscription_;
  std::shared_ptr<rclcpp_lifecycle::LifecyclePublisher<std_msgs::msg::Bool>> commands_;
};

}  // namespace heater
