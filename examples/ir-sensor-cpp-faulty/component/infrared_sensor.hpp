#pragma once

#include <vector>

#include "sitaf/hardware.hpp"

namespace robot {

/// The infrared sensors of a robot, numbered from 1. The methods have the names of the interface
/// InfraredSensorService.
class InfraredSensor {
 public:
  /// The value that GetInfraredData returns if there is no distance.
  static constexpr double noDistance = -1.0;

  /// Uses the range sensors `ir1`, `ir2` and so on.
  explicit InfraredSensor(sitaf::Hardware& hardware);

  /// Property `Size`: the number of sensors, at least 1.
  void setSize(int size);

  /// Opens the sensors. Before this call, there is no distance.
  void Enable();

  /// Releases the sensors.
  void Disable();

  /// Whether the sensors are open.
  bool IsEnabled() const;

  /// The distance that one sensor measures, in metres; noDistance if an argument is out of range
  /// or no object is within the range of the sensor.
  ///
  /// - indexOfSensor: the number of the sensor, 1 to numOfSensor
  /// - numOfSensor: the number of sensors that the caller uses, 1 to `Size`
  double GetInfraredData(int indexOfSensor, int numOfSensor) const;

 private:
  sitaf::Hardware& hardware_;
  std::vector<const sitaf::RangeSensor*> sensors_;
  int size_ = 1;
};

}  // namespace robot
