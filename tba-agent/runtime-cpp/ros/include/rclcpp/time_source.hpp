#pragma once

#include <memory>

#include "rclcpp/node.hpp"

namespace rclcpp {

/// Clocks follow the time of the case without one.
class TimeSource
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(TimeSource)
  TimeSource() = default;
  template<class ... Args>
  explicit TimeSource(Args && ...) {}
  template<class ... Args>
  void attachNode(Args && ...) {}
  void detachNode() {}
  void attachClock(Clock::SharedPtr) {}
  void detachClock(Clock::SharedPtr) {}
};

}  // namespace rclcpp
