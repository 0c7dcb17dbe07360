#include "limiter/acceleration_limiter.hpp"

#include <stdexcept>

#include "limiter/limits.hpp"

namespace limiter {

double AccelerationLimiter::Limit(double velocity, double target, double time_step) const {
  if (!(time_step > 0.0)) throw std::invalid_argument("the time step must be positive");
  return within(target, velocity, kMaxAcceleration * time_step);
}

}  // namespace limiter
