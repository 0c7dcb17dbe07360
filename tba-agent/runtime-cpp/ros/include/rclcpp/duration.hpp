#pragma once

#include <chrono>
#include <cstdint>

#include "builtin_interfaces/msg/duration.hpp"

typedef struct rmw_time_s
{
  std::uint64_t sec;
  std::uint64_t nsec;
} rmw_time_t;

typedef std::int64_t rcl_duration_value_t;
typedef std::int64_t rcl_time_point_value_t;

namespace rclcpp {

class Duration
{
public:
  Duration() = delete;
  Duration(std::int32_t seconds, std::uint32_t nanoseconds)
  : nanos_(std::int64_t{seconds} * 1'000'000'000 + nanoseconds) {}
  explicit Duration(std::chrono::nanoseconds time)
  : nanos_(time.count()) {}
  template<class R, class P>
  Duration(const std::chrono::duration<R, P> & time)
  : nanos_(std::chrono::duration_cast<std::chrono::nanoseconds>(time).count()) {}
  Duration(const builtin_interfaces::msg::Duration & message)
  : nanos_(std::int64_t{message.sec} * 1'000'000'000 + message.nanosec) {}

  static Duration from_seconds(double seconds) {return from_nanoseconds(static_cast<std::int64_t>(seconds * 1e9));}
  static Duration from_nanoseconds(rcl_duration_value_t nanos) {return Duration(std::chrono::nanoseconds(nanos));}
  static Duration from_rmw_time(rmw_time_t time)
  {
    return from_nanoseconds(static_cast<std::int64_t>(time.sec * 1'000'000'000 + time.nsec));
  }
  static Duration max() {return from_nanoseconds(INT64_MAX);}

  operator builtin_interfaces::msg::Duration() const
  {
    builtin_interfaces::msg::Duration message;
    std::int64_t sec = nanos_ / 1'000'000'000, rest = nanos_ % 1'000'000'000;
    if (rest < 0) {
      --sec;
      rest += 1'000'000'000;
    }
    message.sec = static_cast<std::int32_t>(sec);
    message.nanosec = static_cast<std::uint32_t>(rest);
    return message;
  }
  Duration & operator=(const builtin_interfaces::msg::Duration & message) {return *this = Duration(message);}

  rcl_duration_value_t nanoseconds() const {return nanos_;}
  double seconds() const {return static_cast<double>(nanos_) / 1e9;}
  template<class D>
  D to_chrono() const {return std::chrono::duration_cast<D>(std::chrono::nanoseconds(nanos_));}
  rmw_time_t to_rmw_time() const
  {
    return {static_cast<std::uint64_t>(nanos_ / 1'000'000'000), static_cast<std::uint64_t>(nanos_ % 1'000'000'000)};
  }

  bool operator==(const Duration & other) const {return nanos_ == other.nanos_;}
  bool operator!=(const Duration & other) const {return nanos_ != other.nanos_;}
  bool operator<(const Duration & other) const {return nanos_ < other.nanos_;}
  bool operator<=(const Duration & other) const {return nanos_ <= other.nanos_;}
  bool operator>(const Duration & other) const {return nanos_ > other.nanos_;}
  bool operator>=(const Duration & other) const {return nanos_ >= other.nanos_;}
  Duration operator+(const Duration & other) const {return from_nanoseconds(nanos_ + other.nanos_);}
  Duration operator-(const Duration & other) const {return from_nanoseconds(nanos_ - other.nanos_);}
  Duration operator*(double scale) const
  {
    return from_nanoseconds(static_cast<std::int64_t>(static_cast<long double>(nanos_) * scale));
  }
  Duration & operator+=(const Duration & other) {nanos_ += other.nanos_; return *this;}
  Duration & operator-=(const Duration & other) {nanos_ -= other.nanos_; return *this;}
  Duration & operator*=(double scale) {return *this = *this * scale;}

private:
  std::int64_t nanos_;
};

}  // namespace rclcpp
