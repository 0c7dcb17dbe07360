#pragma once

#include <string>
#include <vector>

namespace sitaf {

/// A laser scanner; shape of sensor_msgs/LaserScan.
class LaserScanner {
 public:
  virtual ~LaserScanner() = default;

  /// The device's name in the world description.
  virtual const std::string& name() const = 0;

  /// Angle of the first ray in radians, counterclockwise from straight ahead.
  virtual double angleMin() const = 0;

  /// Angle of the last ray in radians.
  virtual double angleMax() const = 0;

  /// Angle between two rays in radians.
  virtual double angleIncrement() const = 0;

  /// Smallest distance that it measures, in metres.
  virtual double minRange() const = 0;

  /// Largest distance that it measures, in metres.
  virtual double maxRange() const = 0;

  /// Distances in metres, one for each ray; infinities and NaN as in REP-117.
  virtual std::vector<double> ranges() const = 0;
};

}  // namespace sitaf
