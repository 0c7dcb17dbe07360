#pragma once

#include <string>

namespace sitaf::suite {

/// A descriptor that the agent opened for the results, in place of a file. Each line begins with its number and a token that the agent
/// wrote to standard input, so that what the component writes there is not taken for a result.
struct ResultsChannel {
  /// Where lines are written; no other code gets its number.
  int descriptor;
  std::string token;

  /// Whether `--results` names a descriptor, such as `fd:3`.
  static bool isNamed(const std::string& results);

  /// Takes descriptor and token, once: what the library took when the program was loaded, or else now. A std::runtime_error where there is
  /// none.
  static ResultsChannel take(const std::string& results);
};

}  // namespace sitaf::suite
