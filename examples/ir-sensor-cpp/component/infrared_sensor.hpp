#pragma once

#include <vector>

#include "sitaf/hardware.hpp"

namespace robot {

/// The infrared sensors of a robot, side by side and numbered from 1. Methods are named as the
/// interface InfraredSensorService has them.
class InfraredSensor {
 public:
  /// What GetInfraredData returns where there is no distance to return.
  static constexpr double noDistance = -1.0;

  /// The sensors of a robot; `ir1`, `ir2` and so on are their devices.
  explicit InfraredSensor(sitaf::Hardware& hardware);

  /// Property `Size`: how many sensors there are, at least 1.
  void setSize(int size);

  /// Finds the sensors. Until then nothing is measured.
  void Enable();

  /// Lets the sensors go.
  void Disable();

  /// Whether the sensors measure.
  bool IsEnabled() const;

  /// The distance that one sensor measures, in metres; noDistance when an argument is out of range,
  /// or the sensor sees nothing within its range.
  ///
  /// - indexOfSensor: which sensor, from 1
  /// - numOfSensor: how many sensors the caller uses, from 1 to `Size`; the index must be among them
  double GetInfraredData(int indexOfSensor, int numOfSensor) const;

 private:
  sitaf::Hardware& hardware_;
  std::vector<const sitaf::RangeSensor*> sensors_;
  int size_ = 1;
};

}  // namespace robot
