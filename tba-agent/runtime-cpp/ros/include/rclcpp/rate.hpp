#pragma once

#include <chrono>
#include <memory>

#include "rclcpp/clock.hpp"

namespace rclcpp {

class RateBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(RateBase)
  virtual ~RateBase() = default;
  virtual bool sleep() = 0;
  virtual bool is_steady() const {return true;}
  virtual rcl_clock_type_t get_type() const {return RCL_STEADY_TIME;}
  virtual void reset() = 0;
};

class Rate : public RateBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Rate)

  explicit Rate(double rate, Clock::SharedPtr clock = std::make_shared<Clock>(RCL_SYSTEM_TIME))
  : Rate(period_of(rate), std::move(clock)) {}
  explicit Rate(const Duration & period, Clock::SharedPtr clock = std::make_shared<Clock>(RCL_SYSTEM_TIME))
  : clock_(std::move(clock)), period_(period), last_(clock_->now()) {}

  bool sleep() override
  {
    const Time now = clock_->now();
    if (now < last_) {
      last_ = now + period_;
    }
    const Time next = last_ + period_;
    last_ = last_ + period_;
    if (next <= now) {
      if (now > next + period_) {
        last_ = now + period_;
      }
      return false;
    }
    clock_->sleep_until(next);
    return true;
  }
  bool is_steady() const override {return clock_->get_clock_type() == RCL_STEADY_TIME;}
  rcl_clock_type_t get_type() const override {return clock_->get_clock_type();}
  void reset() override {last_ = clock_->now();}
  std::chrono::nanoseconds period() const {return std::chrono::nanoseconds(period_.nanoseconds());}

private:
  static Duration period_of(double rate)
  {
    if (rate <= 0) {
      throw std::invalid_argument("rate must be greater than 0");
    }
    return Duration::from_seconds(1.0 / rate);
  }

  Clock::SharedPtr clock_;
  Duration period_;
  Time last_;
};

class WallRate : public Rate
{
public:
  explicit WallRate(double rate)
  : Rate(rate, std::make_shared<Clock>(RCL_STEADY_TIME)) {}
  explicit WallRate(const Duration & period)
  : Rate(period, std::make_shared<Clock>(RCL_STEADY_TIME)) {}
};

class ROSRate : public Rate
{
public:
  explicit ROSRate(double rate)
  : Rate(rate, std::make_shared<Clock>(RCL_ROS_TIME)) {}
  explicit ROSRate(const Duration & period)
  : Rate(period, std::make_shared<Clock>(RCL_ROS_TIME)) {}
};

template<class C = std::chrono::high_resolution_clock>
class GenericRate : public Rate
{
public:
  explicit GenericRate(double rate)
  : Rate(rate) {}
  explicit GenericRate(std::chrono::nanoseconds period)
  : Rate(Duration(period)) {}
};

}  // namespace rclcpp
