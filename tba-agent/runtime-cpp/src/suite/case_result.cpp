#include "sitaf/suite/case_result.hpp"

#include <cmath>

#include "sitaf/suite/literals.hpp"
#include "suite/record_line.hpp"

namespace sitaf::suite {
namespace {

/// Longest value in the text about a difference, in bytes.
constexpr std::size_t maxDifference = 200;

std::string shortened(const std::string& text) { return text.size() <= maxDifference ? text : text.substr(0, maxDifference) + "..."; }

}  // namespace

void CaseResult::setTime(double component, double hardware, double stub) {
  timed_ = true;
  component_ = component;
  hardware_ = hardware;
  stub_ = stub;
}

void CaseResult::recordValue(std::string_view output, const Value& value) { put(output, literals::write(value)); }

void CaseResult::recordNull(std::string_view output) { put(output, "null"); }

void CaseResult::put(std::string_view output, std::string literal) {
  for (auto& [name, recorded] : actual_) {
    if (name == output) {
      recorded = std::move(literal);
      return;
    }
  }
  actual_.emplace_back(output, std::move(literal));
}

void CaseResult::threw(const std::string& type, std::string_view description) {
  thrown_ = type;
  endWith(Outcome::threw, description);
}

void CaseResult::endWith(Outcome outcome, std::string_view reason) {
  outcome_ = outcome;
  message_ += message_.empty() ? "" : "; ";
  message_ += reason;
}

void CaseResult::addRepeated(const CaseResult& again, int number, bool measured) {
  if (differs_.empty()) {
    const std::string difference = again.differenceFrom(*this);
    if (!difference.empty()) {
      differs_ = "call " + std::to_string(number) + ": " + difference;
    }
  }
  if (measured && again.timed_ && again.outcome_ == outcome_) {
    repeatedNanos_.push_back(std::llround(again.component_ * 1000));
  }
}

std::string CaseResult::differenceFrom(const CaseResult& first) const {
  if (outcome_ != first.outcome_ || thrown_ != first.thrown_) {
    return ending() + ", but the first call " + first.ending();
  }
  for (const auto& [output, literal] : actual_) {
    std::string before = "null";
    for (const auto& [name, recorded] : first.actual_) {
      before = name == output ? recorded : before;
    }
    if (literal != before) {
      return output + " is " + shortened(literal) + ", not " + shortened(before);
    }
  }
  return "";
}

std::string CaseResult::ending() const {
  switch (outcome_) {
    case Outcome::returned:
      return "returned";
    case Outcome::threw:
      return "threw " + shortened(thrown_);
    default:
      return "failed: " + shortened(message_);
  }
}

std::string CaseResult::line() const {
  RecordLine line = step_ == nullptr ? RecordLine(testCase_.no(), outcome_) : RecordLine(*step_, outcome_, at_);
  if (outcome_ == Outcome::threw) {
    line.thrown(thrown_);
  }
  for (const auto& [output, literal] : actual_) {
    line.actual(output, literal);
  }
  line.calls(calls_);
  for (const PortChanges& port : ports_) {
    line.port(port);
  }
  if (timed_) {
    line.time(component_, hardware_, stub_);
  }
  if (repeated_) {
    line.repeated(repeatedNanos_, differs_);
  }
  if (!message_.empty()) {
    line.message(message_);
  }
  return line.close();
}

}  // namespace sitaf::suite
