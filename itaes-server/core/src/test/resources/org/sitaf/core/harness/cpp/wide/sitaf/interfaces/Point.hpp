#pragma once

#include "sitaf/suite/value.hpp"

namespace sitaf::interfaces {

/// The struct Point of the interfaces.
struct Point {
  double x{};
  double y{};
};

}  // namespace sitaf::interfaces

/// Conversion to text in results.
template <>
struct sitaf::suite::Structure<sitaf::interfaces::Point> {
  template <class Value, class Visit>
  static void each(Value& value, Visit visit) {
    visit("x", value.x);
    visit("y", value.y);
  }
};
