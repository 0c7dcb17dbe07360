#pragma once

#include <string>

#include "sitaf/geometry.hpp"

namespace sitaf {

/// A magnetometer, in its own frame.
class Magnetometer {
 public:
  virtual ~Magnetometer() = default;

  /// The device's name in the world description.
  virtual const std::string& name() const = 0;

  /// Magnetic field in tesla.
  virtual Vector field() const = 0;
};

}  // namespace sitaf
