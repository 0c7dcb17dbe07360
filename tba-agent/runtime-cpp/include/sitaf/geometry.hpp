#pragma once

namespace sitaf {

/// A vector; the method that returns it documents the unit.
struct Vector {
  double x = 0;
  double y = 0;
  double z = 0;
};

/// A rotation as a unit quaternion.
struct Quaternion {
  double x = 0;
  double y = 0;
  double z = 0;
  double w = 1;
};

}  // namespace sitaf
