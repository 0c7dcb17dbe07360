#pragma once

#include <string>

namespace sitaf {

/// A base on two driven wheels.
class DifferentialDrive {
 public:
  virtual ~DifferentialDrive() = default;

  /// The device's name in the world description.
  virtual const std::string& name() const = 0;

  /// Measured speed in metres per second, forward.
  virtual double linear() const = 0;

  /// Measured turning in radians per second, counterclockwise.
  virtual double angular() const = 0;

  /// Radians that the left wheel has turned.
  virtual double leftPosition() const = 0;

  /// Radians that the right wheel has turned.
  virtual double rightPosition() const = 0;

  /// Commands a speed in m/s and a turning in rad/s; std::invalid_argument beyond its limits.
  virtual void drive(double linear, double angular) = 0;
};

}  // namespace sitaf
