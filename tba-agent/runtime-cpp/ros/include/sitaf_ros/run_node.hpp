// Runs a node's class.
#pragma once

#include <memory>

#include "rclcpp/rclcpp.hpp"
#include "sitaf_ros/arguments.hpp"

namespace sitaf_ros {

/// Makes a node and spins it to the end of the case.
template<class N>
void run_node()
{
  rclcpp::init(argument_count(), arguments());
  std::shared_ptr<N> node;
  if constexpr (std::is_constructible_v<N, const rclcpp::NodeOptions &>) {
    node = std::make_shared<N>(rclcpp::NodeOptions());
  } else {
    static_assert(
      std::is_default_constructible_v<N>, "the constructor of a node under test takes nothing, or NodeOptions");
    node = std::make_shared<N>();
  }
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(node->get_node_base_interface());
  executor.spin();
  rclcpp::shutdown();
}

}  // namespace sitaf_ros
