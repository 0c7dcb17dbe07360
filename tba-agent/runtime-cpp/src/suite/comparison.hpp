#pragma once

#include <string>
#include <string_view>

#include "sitaf/suite/tolerance.hpp"
#include "sitaf/suite/value.hpp"

namespace sitaf::suite {

/// The first difference between the value of an output and the literal that is expected, in words; empty when there is none.
///
/// - Numbers compare as numbers within the tolerance: -1 equals -1.0. NaN equals NaN, an infinity only itself, and a tolerance never
///   makes an infinity of a finite number.
/// - For a float the expected number is first rounded to one: 0.1 is expected as 0.1f.
/// - Sequences compare element by element, structs member by member; strings, characters and booleans have no tolerance.
std::string difference(std::string_view expected, const Value& actual, const Tolerance& tolerance);

}  // namespace sitaf::suite
