#pragma once

#include <string>
#include <vector>

#include "sitaf/interfaces/Point.hpp"
#include "sitaf/suite/value.hpp"

namespace sitaf::interfaces {

/// The struct Path of the interfaces.
struct Path {
  std::string name{};
  std::vector<Point> points{};
};

}  // namespace sitaf::interfaces

/// Conversion to text in results.
template <>
struct sitaf::suite::Structure<sitaf::interfaces::Path> {
  template <class Value, class Visit>
  static void each(Value& value, Visit visit) {
    visit("name", value.name);
    visit("points", value.points);
  }
};
