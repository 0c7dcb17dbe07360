#pragma once

#include <string>

namespace sitaf {

/// A digital input or output.
class DigitalLine {
 public:
  virtual ~DigitalLine() = default;

  /// The device's name in the world description.
  virtual const std::string& name() const = 0;

  /// Its level.
  virtual bool isHigh() const = 0;

  /// Sets its level.
  virtual void set(bool high) = 0;
};

}  // namespace sitaf
