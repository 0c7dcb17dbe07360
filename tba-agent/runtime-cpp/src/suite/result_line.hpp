#pragma once

#include <string>
#include <string_view>

#include "sitaf/suite/stub_call.hpp"
#include "sitaf/suite/verdict.hpp"

namespace sitaf::suite {

/// Prints one `test_result` element (paper, Fig. 11) on one line.
///
/// Line breaks and the like inside of values are written as character references. A character that XML cannot hold, and a byte that is no
/// UTF-8, is written as `\u0000`; backslashes themselves stay as they are.
class ResultLine {
 public:
  ResultLine(int no, Verdict verdict);

  void value(std::string_view literal) { element("value", "", literal); }

  /// An expected or actual value; an empty name means the only output.
  void output(std::string_view element, std::string_view name, std::string_view literal) { this->element(element, name, literal); }

  /// What the component asked of its required interfaces.
  void calls(const StubCalls& calls);

  /// In microseconds.
  void time(double component, double hardware, double stub);

  void message(std::string_view text);

  std::string close();

 private:
  void element(std::string_view element, std::string_view name, std::string_view content);
  void escape(std::string_view text);

  std::string xml_;
};

}  // namespace sitaf::suite
