#pragma once

namespace sitaf {

/// Three numbers along x, y and z; the unit stands where it is used.
struct Vector {
  double x = 0;
  double y = 0;
  double z = 0;
};

/// A rotation, of unit length.
struct Quaternion {
  double x = 0;
  double y = 0;
  double z = 0;
  double w = 1;
};

}  // namespace sitaf
