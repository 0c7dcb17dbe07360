#pragma once

#include <string>

#include "sitaf/geometry.hpp"

namespace sitaf {

/// A force and torque sensor, in its own frame.
class ForceTorqueSensor {
 public:
  virtual ~ForceTorqueSensor() = default;

  /// The device's name in the world description.
  virtual const std::string& name() const = 0;

  /// Newtons.
  virtual Vector force() const = 0;

  /// Newton metres.
  virtual Vector torque() const = 0;
};

}  // namespace sitaf
