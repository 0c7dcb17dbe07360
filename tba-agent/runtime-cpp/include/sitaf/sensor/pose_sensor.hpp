#pragma once

#include <string>

#include "sitaf/geometry.hpp"

namespace sitaf {

/// A sensor of position and orientation in the world.
class PoseSensor {
 public:
  virtual ~PoseSensor() = default;

  /// The device's name in the world description.
  virtual const std::string& name() const = 0;

  /// Metres.
  virtual Vector position() const = 0;

  /// Its orientation in the world.
  virtual Quaternion orientation() const = 0;
};

}  // namespace sitaf
