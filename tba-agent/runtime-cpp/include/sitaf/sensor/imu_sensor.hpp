#pragma once

#include <string>

#include "sitaf/geometry.hpp"

namespace sitaf {

/// An inertial measurement unit; shape of sensor_msgs/Imu, in its own frame.
class ImuSensor {
 public:
  virtual ~ImuSensor() = default;

  /// The device's name in the world description.
  virtual const std::string& name() const = 0;

  /// Its orientation in the world.
  virtual Quaternion orientation() const = 0;

  /// Radians per second.
  virtual Vector angularVelocity() const = 0;

  /// Metres per second squared, including gravity: at rest it points upwards.
  virtual Vector linearAcceleration() const = 0;
};

}  // namespace sitaf
