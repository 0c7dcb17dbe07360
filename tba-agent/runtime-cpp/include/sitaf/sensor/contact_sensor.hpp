#pragma once

#include <string>

namespace sitaf {

/// A contact sensor, such as a bumper.
class ContactSensor {
 public:
  virtual ~ContactSensor() = default;

  /// The device's name in the world description.
  virtual const std::string& name() const = 0;

  /// Whether it is pressed.
  virtual bool isPressed() const = 0;

  /// Contact force in newtons.
  virtual double force() const = 0;
};

}  // namespace sitaf
