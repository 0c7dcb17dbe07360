#pragma once

#include "sitaf/sensor/joint_encoder.hpp"

namespace sitaf {

/// A motor of a joint. The world description defines which command it supports. An unsupported command, or one beyond the
/// limits, throws std::invalid_argument.
class JointMotor : public JointEncoder {
 public:
  /// Measured effort in newton metres or newtons.
  virtual double effort() const = 0;

  /// Commands a position in radians or metres.
  virtual void setPosition(double target) = 0;

  /// Commands a velocity in radians or metres per second.
  virtual void setVelocity(double target) = 0;

  /// Commands an effort in newton metres or newtons.
  virtual void setEffort(double target) = 0;
};

}  // namespace sitaf
