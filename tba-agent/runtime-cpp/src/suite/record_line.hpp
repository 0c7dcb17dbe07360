#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "sitaf/suite/outcome.hpp"
#include "sitaf/suite/port_changes.hpp"
#include "sitaf/suite/stub_call.hpp"
#include "sitaf/suite/test_case.hpp"

namespace sitaf::suite {

/// Prints one `case_record` or `step_record` element on one line (docs/test-application.md, The record of a case).
///
/// Line breaks and tabs within values are written as character references. A character that XML cannot hold, and a byte that is not UTF-8,
/// is written as `\u0000`; backslashes are not escaped.
class RecordLine {
 public:
  RecordLine(int no, Outcome outcome);

  /// The record of a step; `at` is the simulation time since the first step of the case.
  RecordLine(const TestStep& step, Outcome outcome, std::chrono::nanoseconds at);

  /// The name of the exception's type, without its scope.
  void thrown(std::string_view type) { element("thrown", "", type); }

  void actual(std::string_view output, std::string_view literal) { element("actual", output, literal); }

  /// The calls of the component to its required interfaces.
  void calls(const StubCalls& calls);

  /// The values of an output data port.
  void port(const PortChanges& port);

  /// In microseconds.
  void time(double component, double hardware, double stub);

  /// The times of repeated calls in nanoseconds, and how one of them differs; empty if none does.
  void repeated(const std::vector<std::int64_t>& nanos, std::string_view differs);

  void message(std::string_view text);

  std::string close();

 private:
  void element(std::string_view element, std::string_view name, std::string_view content);
  void escape(std::string_view text);

  std::string xml_;
  const char* root_;
};

}  // namespace sitaf::suite
