#pragma once

#include <string>

namespace sitaf {

/// A sensor that measures the distance to the nearest surface along its ray; shape of sensor_msgs/Range.
class RangeSensor {
 public:
  virtual ~RangeSensor() = default;

  /// The device's name in the world description.
  virtual const std::string& name() const = 0;

  /// The distance at the current step in metres. As in REP-117: positive infinity when nothing is within maxRange(),
  /// negative infinity when an object is nearer than minRange() or the sensor is inside an object, NaN when the reading is invalid.
  virtual double range() const = 0;

  /// Smallest distance that the sensor measures, in metres, inclusive.
  virtual double minRange() const = 0;

  /// Largest distance that the sensor measures, in metres, inclusive.
  virtual double maxRange() const = 0;
};

}  // namespace sitaf
