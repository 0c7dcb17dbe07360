#pragma once

#include <array>
#include <string_view>
#include <utility>

#include "sitaf/suite/value.hpp"

namespace sitaf::interfaces {

/// The enumeration Mode of the interfaces.
enum class Mode { SLOW, FAST };

}  // namespace sitaf::interfaces

/// Conversion to text in results.
template <>
struct sitaf::suite::Enumeration<sitaf::interfaces::Mode> {
  using Type = sitaf::interfaces::Mode;
  static constexpr std::array<std::pair<std::string_view, Type>, 2> literals = {{
      {"SLOW", Type::SLOW},
      {"FAST", Type::FAST}
  }};
};
