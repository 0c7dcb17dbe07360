#include "infrared_sensor.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

namespace robot {

InfraredSensor::InfraredSensor(sitaf::Hardware& hardware) : hardware_(hardware) {}

void InfraredSensor::setSize(int size) {
  if (size < 1) {
    throw std::invalid_argument("Size must be at least 1, not " + std::to_string(size));
  }
  size_ = size;
}

void InfraredSensor::Enable() {
  Disable();
  for (int i = 1; i <= size_; ++i) {
    sensors_.push_back(&hardware_.rangeSensor("ir" + std::to_string(i)));
  }
}

void InfraredSensor::Disable() { sensors_.clear(); }

bool InfraredSensor::IsEnabled() const { return !sensors_.empty(); }

double InfraredSensor::GetInfraredData(int indexOfSensor, int numOfSensor) const {
  if (numOfSensor < 1 || numOfSensor > static_cast<int>(sensors_.size())) {
    return noDistance;
  }
  if (indexOfSensor < 1 || indexOfSensor >= numOfSensor) {
    return noDistance;
  }
  const double range = sensors_[static_cast<std::size_t>(indexOfSensor - 1)]->range();
  return std::isfinite(range) ? range : noDistance;
}

}  // namespace robot
