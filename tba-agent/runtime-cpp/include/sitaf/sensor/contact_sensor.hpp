#pragma once

#include <string>

namespace sitaf {

/// A bumper.
class ContactSensor {
 public:
  virtual ~ContactSensor() = default;

  /// The device's name in the world description.
  virtual const std::string& name() const = 0;

  /// Whether anything presses on it.
  virtual bool isPressed() const = 0;

  /// How hard, in newtons.
  virtual double force() const = 0;
};

}  // namespace sitaf
