#pragma once

#include <string>
#include <string_view>
#include <type_traits>

#include "sitaf/suite/literals.hpp"
#include "sitaf/suite/test_case.hpp"

namespace sitaf::suite {

/// The return type of a method without a return value.
struct Nothing {};

/// The behaviour of a stubbed method: `VALUE`, `!error:NAME` or `!delay:SECONDS`; a value or an error may follow a delay after a space.
template <class T>
struct Answer {
  /// In seconds of simulation time; of real time when there is no world.
  double delay = 0;
  /// Name of the error to throw; empty when a value is returned.
  std::string error;
  /// The value to return.
  T value{};
};

/// Reads delay and error and returns the rest, the literal of a value if `hasValue`. CaseDataError for an invalid delay.
std::string_view readAnswer(std::string_view literal, double& delay, std::string& error, bool& hasValue);

/// The answer of a case.
template <class T>
Answer<T> answer(const TestCase& testCase, std::string_view column) {
  Answer<T> result;
  bool hasValue = false;
  const std::string& literal = testCase.literal(column);
  try {
    const std::string_view value = readAnswer(literal, result.delay, result.error, hasValue);
    if constexpr (!std::is_same_v<T, Nothing>) {
      if (hasValue) {
        result.value = literals::read<T>(value);
      }
    }
  } catch (const CaseDataError& e) {
    throw CaseDataError(std::string(column) + ": " + e.what());
  }
  return result;
}

}  // namespace sitaf::suite
