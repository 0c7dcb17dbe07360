// Conversions between types of tf2 and messages.
#pragma once

#include <array>
#include <string>
#include <utility>

#include "geometry_msgs/msg/transform_stamped.hpp"
#include "tf2/buffer_core.hpp"

namespace tf2 {

template<class T>
class Stamped : public T
{
public:
  TimePoint stamp_{};
  std::string frame_id_ = "NO_ID_STAMPED_DEFAULT_CONSTRUCTION";
  Stamped() = default;
  Stamped(const T & value, const TimePoint & stamp, const std::string & frame)
  : T(value), stamp_(stamp), frame_id_(frame) {}
  void setData(const T & value) {*static_cast<T *>(this) = value;}
};

inline TimePoint sitaf_time_point(const builtin_interfaces::msg::Time & time)
{
  return TimePoint(std::chrono::nanoseconds(std::int64_t{time.sec} * 1'000'000'000 + time.nanosec));
}

template<class T>
void doTransform(const T & in, T & out, const geometry_msgs::msg::TransformStamped & transform);
template<class T>
TimePoint getTimestamp(const T & value)
{
  return sitaf_time_point(value.header.stamp);
}
template<class T>
std::string getFrameId(const T & value)
{
  return value.header.frame_id;
}
template<class T>
TimePoint getTimestamp(const Stamped<T> & value)
{
  return value.stamp_;
}
template<class T>
std::string getFrameId(const Stamped<T> & value)
{
  return value.frame_id_;
}

template<class A, class B>
auto convert(const A & a, B & b)->decltype(fromMsg(a, b), void()) {fromMsg(a, b);}
template<class A, class B>
auto convert(const A & a, B & b)->decltype(b = toMsg(a), void()) {b = toMsg(a);}
template<class A>
void convert(const A & a, A & b)
{
  b = a;
}

}  // namespace tf2
