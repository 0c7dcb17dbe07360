#include "sitaf/suite/case_result.hpp"

#include "sitaf/suite/literals.hpp"
#include "suite/record_line.hpp"

namespace sitaf::suite {

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

std::string CaseResult::line() const {
  RecordLine line(testCase_.no(), outcome_);
  if (outcome_ == Outcome::threw) {
    line.thrown(thrown_);
  }
  for (const auto& [output, literal] : actual_) {
    line.actual(output, literal);
  }
  line.calls(calls_);
  if (timed_) {
    line.time(component_, hardware_, stub_);
  }
  if (!message_.empty()) {
    line.message(message_);
  }
  return line.close();
}

}  // namespace sitaf::suite
