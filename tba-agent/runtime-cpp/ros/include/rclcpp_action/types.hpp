#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <random>
#include <string>

#include "action_msgs/msg/goal_info.hpp"
#include "action_msgs/msg/goal_status.hpp"
#include "action_msgs/msg/goal_status_array.hpp"
#include "action_msgs/srv/cancel_goal.hpp"
#include "rclcpp/rclcpp.hpp"

namespace rclcpp_action {

using GoalUUID = std::array<std::uint8_t, 16>;
using GoalStatus = action_msgs::msg::GoalStatus;
using GoalInfo = action_msgs::msg::GoalInfo;

std::string to_string(const GoalUUID & id);

enum class GoalResponse : std::int8_t {REJECT = 1, ACCEPT_AND_EXECUTE = 2, ACCEPT_AND_DEFER = 3};
enum class CancelResponse : std::int8_t {REJECT = 1, ACCEPT = 2};
enum class ResultCode : std::int8_t
{
  UNKNOWN = GoalStatus::STATUS_UNKNOWN, SUCCEEDED = GoalStatus::STATUS_SUCCEEDED,
  CANCELED = GoalStatus::STATUS_CANCELED, ABORTED = GoalStatus::STATUS_ABORTED
};

namespace exceptions {

class UnknownGoalHandleError : public std::invalid_argument
{
public:
  UnknownGoalHandleError()
  : std::invalid_argument("Goal handle is not known to this client.") {}
};
class UnawareGoalHandleError : public std::runtime_error
{
public:
  UnawareGoalHandleError(const std::string & text = "Goal handle is not tracking the goal result.")
  : std::runtime_error(text) {}
};

}  // namespace exceptions
}  // namespace rclcpp_action

namespace std {

template<>
struct less<rclcpp_action::GoalUUID>
{
  bool operator()(const rclcpp_action::GoalUUID & a, const rclcpp_action::GoalUUID & b) const
  {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  }
};
template<>
struct hash<rclcpp_action::GoalUUID>
{
  size_t operator()(const rclcpp_action::GoalUUID & id) const noexcept
  {
    size_t result = 0;
    for (const auto byte : id) {
      result = result * 131 + byte;
    }
    return result;
  }
};

}  // namespace std
