#pragma once

#include <string>

namespace sitaf {

/// An encoder of a joint.
class JointEncoder {
 public:
  virtual ~JointEncoder() = default;

  /// The device's name in the world description.
  virtual const std::string& name() const = 0;

  /// Radians, or metres for a prismatic joint.
  virtual double position() const = 0;

  /// Radians or metres per second.
  virtual double velocity() const = 0;
};

}  // namespace sitaf
