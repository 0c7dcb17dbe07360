#include "rclcpp_action/types.hpp"

#include <cstdio>

namespace rclcpp_action {

std::string to_string(const GoalUUID & id)
{
  std::string text;
  char byte[4];
  for (const auto part : id) {
    std::snprintf(byte, sizeof byte, "%02x", part);
    text += byte;
  }
  return text;
}

}  // namespace rclcpp_action
