#pragma once

#include <chrono>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sitaf/suite/outcome.hpp"
#include "sitaf/suite/port_changes.hpp"
#include "sitaf/suite/stub_call.hpp"
#include "sitaf/suite/test_case.hpp"
#include "sitaf/suite/value.hpp"

namespace sitaf::suite {

/// The record of a case or of a step. The test driver fills it in and saves it; the agent adds expected values and verdicts.
class CaseResult {
 public:
  /// Creates an empty record of a case; the case must live as long as the record.
  explicit CaseResult(const TestCase& testCase) : testCase_(testCase) {}

  /// Creates an empty record of a step; the step must live as long as the record.
  explicit CaseResult(const TestStep& step) : testCase_(step), step_(&step) {}

  /// Sets when a step began: simulation time since the first step of the case.
  void beganAt(std::chrono::nanoseconds time) { at_ = time; }

  /// Sets the processing time in microseconds; `component` excludes the other two.
  void setTime(double component, double hardware, double stub);

  /// Records the value of an output.
  template <class T>
  void record(std::string_view output, const T& value) {
    recordValue(output, valueOf(value));
  }

  /// Records a part of an output, which `read` returns; `null` when the value has no such element.
  template <class Read>
  void recordPart(std::string_view output, Read read) {
    try {
      record(output, read());
    } catch (const std::out_of_range&) {
      recordNull(output);
    }
  }

  /// Records that a method without a return value returned.
  void recordReturn(std::string_view output) { recordNull(output); }

  /// Sets the calls of the component to its required interfaces.
  void setCalls(StubCalls calls) { calls_ = std::move(calls); }

  /// Adds the values of an output data port during the case, with times since the call.
  void addPort(PortChanges port) { ports_.push_back(std::move(port)); }

  /// Ends the case with an exception of the call under test; `type` is its name without its scope.
  void threw(const std::string& type, std::string_view description);

  /// Sets the outcome of a case that did not return; the reason is appended to the message.
  void endWith(Outcome outcome, std::string_view reason);

  /// Ends a step that was stopped before its end; how it reacted to that does not count.
  void stopped(std::string_view reason) {
    thrown_.clear();
    message_.clear();
    endWith(Outcome::error, reason);
  }

  /// Whether the component was called and nothing else failed.
  bool isRepeatable() const { return outcome_ == Outcome::returned || outcome_ == Outcome::threw; }

  /// From now on, repeated calls of the case are added.
  void beginRepeated() { repeated_ = true; }

  /// Adds the record of a repeated call with its number, from 2. The time of a call that is not measured does not count.
  void addRepeated(const CaseResult& again, int number, bool measured);

  /// The record as one line of XML that ends with a line feed.
  std::string line() const;

 private:
  void recordValue(std::string_view output, const Value& value);
  void recordNull(std::string_view output);
  void put(std::string_view output, std::string literal);
  std::string differenceFrom(const CaseResult& first) const;
  std::string ending() const;

  const TestCase& testCase_;
  const TestStep* step_ = nullptr;
  std::chrono::nanoseconds at_{0};
  std::vector<std::pair<std::string, std::string>> actual_;
  bool timed_ = false;
  double component_ = 0;
  double hardware_ = 0;
  double stub_ = 0;
  Outcome outcome_ = Outcome::returned;
  std::string thrown_;
  std::string message_;
  StubCalls calls_;
  std::vector<PortChanges> ports_;
  bool repeated_ = false;
  std::vector<std::int64_t> repeatedNanos_;
  std::string differs_;
};

}  // namespace sitaf::suite
