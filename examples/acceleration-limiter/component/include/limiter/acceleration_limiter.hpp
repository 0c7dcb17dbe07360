#pragma once

#include <Eigen/Core>
#include <concepts>

namespace limiter {

/** Restricts a value to the range of +-limit around another one. */
template <std::floating_point T>
T within(T value, T center, T limit) {
  const Eigen::Array<T, 1, 1> array(value);
  return array.max(center - limit).min(center + limit)(0);
}

class AccelerationLimiter {
 public:
  double Limit(double velocity, double target, double time_step) const;
};

}  // namespace limiter
