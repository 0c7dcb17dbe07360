#pragma once

#include <string>

namespace sitaf {

/// A mobile base with two driven wheels.
class DifferentialDrive {
 public:
  virtual ~DifferentialDrive() = default;

  /// The device's name in the world description.
  virtual const std::string& name() const = 0;

  /// Measured linear speed in metres per second, forward.
  virtual double linear() const = 0;

  /// Measured angular speed in radians per second, counterclockwise.
  virtual double angular() const = 0;

  /// Rotation of the left wheel in radians.
  virtual double leftPosition() const = 0;

  /// Rotation of the right wheel in radians.
  virtual double rightPosition() const = 0;

  /// Commands a linear speed in m/s and an angular speed in rad/s; std::invalid_argument beyond the limits.
  virtual void drive(double linear, double angular) = 0;
};

}  // namespace sitaf
