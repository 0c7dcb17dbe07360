#pragma once

#include <stdexcept>

#include "builtin_interfaces/msg/time.hpp"
#include "rclcpp/duration.hpp"

typedef enum rcl_clock_type_e
{
  RCL_CLOCK_UNINITIALIZED = 0,
  RCL_ROS_TIME,
  RCL_SYSTEM_TIME,
  RCL_STEADY_TIME
} rcl_clock_type_t;

namespace rclcpp {

class Time
{
public:
  Time(std::int32_t seconds, std::uint32_t nanoseconds, rcl_clock_type_t type = RCL_SYSTEM_TIME)
  : nanos_(std::int64_t{seconds} * 1'000'000'000 + nanoseconds), type_(type)
  {
    if (seconds < 0) {
      throw std::runtime_error("cannot store a negative time point in rclcpp::Time");
    }
  }
  explicit Time(std::int64_t nanoseconds = 0, rcl_clock_type_t type = RCL_SYSTEM_TIME)
  : nanos_(nanoseconds), type_(type) {}
  Time(const Time &) = default;
  Time(const builtin_interfaces::msg::Time & message, rcl_clock_type_t type = RCL_ROS_TIME)
  : nanos_(std::int64_t{message.sec} * 1'000'000'000 + message.nanosec), type_(type)
  {
    if (message.sec < 0) {
      throw std::runtime_error("cannot store a negative time point in rclcpp::Time");
    }
  }

  operator builtin_interfaces::msg::Time() const
  {
    builtin_interfaces::msg::Time message;
    message.sec = static_cast<std::int32_t>(nanos_ / 1'000'000'000);
    message.nanosec = static_cast<std::uint32_t>(nanos_ % 1'000'000'000);
    return message;
  }
  Time & operator=(const Time &) = default;
  Time & operator=(const builtin_interfaces::msg::Time & message) {return *this = Time(message);}

  rcl_time_point_value_t nanoseconds() const {return nanos_;}
  double seconds() const {return static_cast<double>(nanos_) / 1e9;}
  rcl_clock_type_t get_clock_type() const {return type_;}
  static Time max(rcl_clock_type_t type = RCL_SYSTEM_TIME) {return Time(INT64_MAX, type);}

  bool operator==(const Time & other) const {return same(other) && nanos_ == other.nanos_;}
  bool operator!=(const Time & other) const {return !(*this == other);}
  bool operator<(const Time & other) const {return same(other) && nanos_ < other.nanos_;}
  bool operator<=(const Time & other) const {return same(other) && nanos_ <= other.nanos_;}
  bool operator>(const Time & other) const {return same(other) && nanos_ > other.nanos_;}
  bool operator>=(const Time & other) const {return same(other) && nanos_ >= other.nanos_;}
  Time operator+(const Duration & time) const {return Time(nanos_ + time.nanoseconds(), type_);}
  Time operator-(const Duration & time) const {return Time(nanos_ - time.nanoseconds(), type_);}
  Duration operator-(const Time & other) const
  {
    if (type_ != other.type_) {
      throw std::runtime_error("can't subtract times with different time sources");
    }
    return Duration::from_nanoseconds(nanos_ - other.nanos_);
  }
  Time & operator+=(const Duration & time) {nanos_ += time.nanoseconds(); return *this;}
  Time & operator-=(const Duration & time) {nanos_ -= time.nanoseconds(); return *this;}
  friend Time operator+(const Duration & duration, const Time & time) {return time + duration;}

private:
  bool same(const Time & other) const
  {
    if (type_ != other.type_) {
      throw std::runtime_error("can't compare times with different time sources");
    }
    return true;
  }

  std::int64_t nanos_;
  rcl_clock_type_t type_;
};

inline builtin_interfaces::msg::Time convert_rcl_time_to_sec_nanos(rcl_time_point_value_t time)
{
  return Time(time);
}

}  // namespace rclcpp
