#pragma once

#include <functional>
#include <memory>
#include <mutex>

#include "rclcpp/macros.hpp"
#include "rclcpp/time.hpp"

namespace rclcpp {

class Context;

class JumpHandler
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(JumpHandler)
};

class Clock : public std::enable_shared_from_this<Clock>
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Clock)

  explicit Clock(rcl_clock_type_t type = RCL_SYSTEM_TIME)
  : type_(type) {}
  virtual ~Clock() = default;

  Time now() const;
  bool sleep_until(Time until, std::shared_ptr<Context> context = nullptr);
  bool sleep_for(Duration time, std::shared_ptr<Context> context = nullptr);
  bool started() {return true;}
  bool wait_until_started(std::shared_ptr<Context> = nullptr) {return true;}
  template<class R, class P>
  bool wait_until_started(const Duration &, std::shared_ptr<Context> = nullptr) {return true;}
  bool ros_time_is_active() const;
  rcl_clock_type_t get_clock_type() const noexcept {return type_;}
  std::mutex & get_clock_mutex() noexcept {return mutex_;}
  template<class ... Args>
  JumpHandler::SharedPtr create_jump_callback(Args && ...) {return std::make_shared<JumpHandler>();}
  template<class ... Args>
  std::unique_ptr<JumpHandler> create_jump_handler(Args && ...) {return std::make_unique<JumpHandler>();}

  /// When a time of this clock is reached, in simulation time.
  std::int64_t sitaf_when(const Time & time) const;

private:
  rcl_clock_type_t type_;
  std::mutex mutex_;
};

}  // namespace rclcpp
