#pragma once

#include "sitaf/sensor/joint_encoder.hpp"

namespace sitaf {

/// A motor at a joint. The world decides which of the commands it takes: a command that it does not take, or beyond its
/// limits, is a std::invalid_argument.
class JointMotor : public JointEncoder {
 public:
  /// What it exerts, in newton metres or newtons.
  virtual double effort() const = 0;

  /// Goes to a position in radians or metres.
  virtual void setPosition(double target) = 0;

  /// Keeps a velocity in radians or metres per second.
  virtual void setVelocity(double target) = 0;

  /// Exerts an effort in newton metres or newtons.
  virtual void setEffort(double target) = 0;
};

}  // namespace sitaf
