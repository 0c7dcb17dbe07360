#pragma once

namespace sitaf::suite {

/// How far an actual number may lie from the expected one: |actual - expected| <= absolute + relative * |expected| + ulp * u, where u is
/// the distance from the expected number to the next.
struct Tolerance {
  /// In the unit of the output, 0 or more.
  double absolute = 0;
  /// A fraction, 0 or more.
  double relative = 0;
  /// Units in the last place, of the type that the output has, 0 or more; a whole number has none.
  double ulp = 0;

  /// Whether no difference is tolerated.
  bool isExact() const { return absolute == 0 && relative == 0 && ulp == 0; }
};

}  // namespace sitaf::suite
