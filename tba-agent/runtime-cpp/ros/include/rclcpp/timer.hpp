#pragma once

#include <chrono>
#include <memory>

#include "rclcpp/node_core.hpp"

namespace rclcpp {

struct TimerInfo
{
  Time expected_call_time;
  Time actual_call_time;
};

class TimerBase : public sitaf_ros::Entity
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(TimerBase)

  TimerBase(
    Clock::SharedPtr clock, std::chrono::nanoseconds period, std::function<void(TimerBase &, const TimerInfo &)> callback,
    bool autostart = true);

  void cancel() {canceled_ = true;}
  bool is_canceled() {return canceled_;}
  void reset();
  bool is_ready();
  std::chrono::nanoseconds time_until_trigger();
  bool is_steady() {return clock_->get_clock_type() == RCL_STEADY_TIME;}
  bool call();
  void execute_callback();
  void execute_callback(const std::shared_ptr<void> &) {execute_callback();}
  std::shared_ptr<TimerBase> get_timer_handle()
  {
    return std::static_pointer_cast<TimerBase>(shared_from_this());
  }
  bool exchange_in_use_by_wait_set_state(bool in_use) {return std::exchange(in_wait_set, in_use);}
  Clock::SharedPtr get_clock() const {return clock_;}
  template<class F>
  void set_on_reset_callback(F) {}
  void clear_on_reset_callback() {}

  std::optional<std::pair<int, std::int64_t>> order() override;
  std::optional<sitaf_ros::Nanos> due() override;
  std::function<void()> take() override;

private:
  Clock::SharedPtr clock_;
  sitaf_ros::Nanos period_;
  sitaf_ros::Nanos next_;
  sitaf_ros::Nanos expected_ = 0;
  std::int64_t created_;
  bool canceled_;
  std::function<void(TimerBase &, const TimerInfo &)> callback_;
};

template<class F>
auto timer_callback(F callback)
{
  return [callback = std::move(callback)](TimerBase & timer, const TimerInfo & info) mutable {
      if constexpr (std::is_invocable_v<F &>) {
        callback();
      } else if constexpr (std::is_invocable_v<F &, TimerBase &>) {
        callback(timer);
      } else {
        callback(info);
      }
      (void)timer;
      (void)info;
    };
}

template<class F>
class GenericTimer : public TimerBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(GenericTimer)
  GenericTimer(
    Clock::SharedPtr clock, std::chrono::nanoseconds period, F && callback, Context::SharedPtr = nullptr,
    bool autostart = true)
  : TimerBase(std::move(clock), period, timer_callback(std::forward<F>(callback)), autostart) {}
};

template<class F>
class WallTimer : public GenericTimer<F>
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(WallTimer)
  WallTimer(std::chrono::nanoseconds period, F && callback, Context::SharedPtr = nullptr, bool autostart = true)
  : GenericTimer<F>(
      std::make_shared<Clock>(RCL_STEADY_TIME), period, std::forward<F>(callback), nullptr, autostart) {}
};

}  // namespace rclcpp
