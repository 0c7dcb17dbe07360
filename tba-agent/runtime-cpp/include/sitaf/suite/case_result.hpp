#pragma once

#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sitaf/suite/stub_call.hpp"
#include "sitaf/suite/test_case.hpp"
#include "sitaf/suite/tolerance.hpp"
#include "sitaf/suite/value.hpp"
#include "sitaf/suite/verdict.hpp"

namespace sitaf::suite {

/// What becomes of one case; the test driver fills it in and saves it.
class CaseResult {
 public:
  /// A result of a case that nothing is known of yet; the case must live as long.
  explicit CaseResult(const TestCase& testCase) : testCase_(testCase) {}

  /// Keeps how long the call took, in microseconds: the component's own time, and apart from it what virtual hardware and stubs took.
  void took(double component, double hardware, double stub);

  /// Keeps an output that nothing is expected of.
  template <class T>
  void record(std::string_view output, const T& value) {
    recordValue(output, valueOf(value));
  }

  /// Keeps an output, and compares it where the case expects something of it.
  template <class T>
  void compare(std::string_view output, const T& value, const Tolerance& tolerance = {}) {
    compareValue(output, valueOf(value), tolerance);
  }

  /// Keeps that a method returned which returns nothing, and compares that where the case expects something: that it returns, `null`, or an
  /// error.
  void returnedNothing(std::string_view output);

  void recordValue(std::string_view output, const Value& value);
  void compareValue(std::string_view output, const Value& value, const Tolerance& tolerance);

  /// Keeps what the component asked of its required interfaces.
  void called(StubCalls calls) { calls_ = std::move(calls); }

  /// The case did not get as far as a comparison, or not through it.
  void endedWith(Verdict verdict, std::string_view reason);

  /// The call threw an error of that name, without its scope; true where the case expects it.
  bool threw(const std::string& error);

  /// The result as one line of XML, line feed included. An expected value that no output was compared with makes an ERROR of a case that
  /// would pass unseen.
  std::string line();

 private:
  bool isNoValue(std::string_view output, const std::string& expected, const std::string& returned);
  void worsen(Verdict verdict, std::string_view reason);
  std::string named(std::string_view output, const std::string& difference) const;

  const TestCase& testCase_;
  std::vector<std::pair<std::string, std::string>> actual_;
  std::set<std::string> compared_;
  bool timed_ = false;
  double component_ = 0;
  double hardware_ = 0;
  double stub_ = 0;
  Verdict verdict_ = Verdict::pass;
  std::string message_;
  StubCalls calls_;
};

}  // namespace sitaf::suite
