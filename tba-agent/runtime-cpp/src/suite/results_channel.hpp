#pragma once

#include <string>

namespace sitaf::suite {

/// A descriptor that the agent opened for the results, instead of a file. Each line starts with its number and a token that the agent wrote
/// to standard input, so that output of the component is not mistaken for a result.
struct ResultsChannel {
  /// A descriptor with a number that no other code knows.
  int descriptor;
  std::string token;

  /// Whether `--results` names a descriptor, such as `fd:3`.
  static bool isNamed(const std::string& results);

  /// Returns the channel that was taken when the program was loaded, otherwise takes it now. Throws std::runtime_error when there is none.
  static ResultsChannel take(const std::string& results);
};

}  // namespace sitaf::suite
