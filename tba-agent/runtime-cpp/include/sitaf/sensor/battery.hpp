#pragma once

#include <string>

namespace sitaf {

/// A battery; shape of sensor_msgs/BatteryState.
class Battery {
 public:
  virtual ~Battery() = default;

  /// The device's name in the world description.
  virtual const std::string& name() const = 0;

  /// Volts.
  virtual double voltage() const = 0;

  /// Amperes, negative while it discharges.
  virtual double current() const = 0;

  /// Ampere hours.
  virtual double charge() const = 0;

  /// 0 to 1.
  virtual double percentage() const = 0;
};

}  // namespace sitaf
