#pragma once

#include <string>

namespace sitaf {

/// A gripper with two fingers.
class Gripper {
 public:
  virtual ~Gripper() = default;

  /// The device's name in the world description.
  virtual const std::string& name() const = 0;

  /// Measured distance between the fingers in metres.
  virtual double width() const = 0;

  /// Force of the fingers in newtons; closing is negative.
  virtual double effort() const = 0;

  /// Moves to a width in metres; std::invalid_argument beyond the limits.
  virtual void move(double width) = 0;
};

}  // namespace sitaf
