#include "sitaf/suite/case_result.hpp"

#include "sitaf/suite/literals.hpp"
#include "suite/comparison.hpp"
#include "suite/result_line.hpp"

namespace sitaf::suite {
namespace {

/// Stands before the name of an error that a case expects.
const std::string errorMark = "!error:";

/// Begins an expected value that could not be worked out.
const std::string unevaluatedMark = "!unevaluated:";

/// What a method returns that returns nothing.
const std::string nothing = "null";

}  // namespace

void CaseResult::took(double component, double hardware, double stub) {
  timed_ = true;
  component_ = component;
  hardware_ = hardware;
  stub_ = stub;
}

void CaseResult::recordValue(std::string_view output, const Value& value) {
  for (auto& [name, literal] : actual_) {
    if (name == output) {
      literal = literals::spelling(value);
      return;
    }
  }
  actual_.emplace_back(output, literals::spelling(value));
}

void CaseResult::compareValue(std::string_view output, const Value& value, const Tolerance& tolerance) {
  recordValue(output, value);
  const std::string* expected = testCase_.expected(output);
  if (expected == nullptr) {
    return;
  }
  if (isNoValue(output, *expected, " " + literals::spelling(value))) {
    return;
  }
  try {
    const std::string found = difference(*expected, value, tolerance);
    if (!found.empty()) {
      worsen(Verdict::fail, named(output, found));
    }
  } catch (const CaseDataError& e) {
    worsen(Verdict::error, named(output, std::string("what is expected cannot be compared with it: ") + e.what()));
  }
}

void CaseResult::returnedNothing(std::string_view output) {
  actual_.emplace_back(output, nothing);
  const std::string* expected = testCase_.expected(output);
  if (expected != nullptr && !isNoValue(output, *expected, "") && *expected != nothing) {
    worsen(Verdict::error,
           "nothing is returned, so that " + *expected + " cannot be expected, but null or an error such as " + errorMark + "NAME");
  }
}

/// Judges an output of which no value is expected, but an error, or that is not known.
bool CaseResult::isNoValue(std::string_view output, const std::string& expected, const std::string& returned) {
  bool byName = false;
  for (const auto& expectation : testCase_.expectations()) {
    byName = byName || expectation.first == output;
  }
  compared_.insert(byName ? std::string(output) : std::string());
  if (expected.compare(0, unevaluatedMark.size(), unevaluatedMark) == 0) {
    worsen(Verdict::error, "what is expected has no value:" + expected.substr(unevaluatedMark.size()));
    return true;
  }
  if (expected.compare(0, errorMark.size(), errorMark) == 0) {
    worsen(Verdict::fail, "expected the error " + expected.substr(errorMark.size()) + ", but it returned" + returned);
    return true;
  }
  return false;
}

void CaseResult::endedWith(Verdict verdict, std::string_view reason) { worsen(verdict, reason); }

bool CaseResult::threw(const std::string& error) {
  bool expected = false;
  for (const auto& [output, literal] : testCase_.expectations()) {
    if (literal == errorMark + error) {
      expected = true;
      actual_.emplace_back(output, literal);
    }
  }
  if (expected) {
    // The other outputs have no value.
    for (const auto& expectation : testCase_.expectations()) {
      compared_.insert(expectation.first);
    }
  }
  return expected;
}

std::string CaseResult::line() {
  if (verdict_ == Verdict::pass) {
    for (const auto& expectation : testCase_.expectations()) {
      if (compared_.count(expectation.first) == 0) {
        worsen(Verdict::error, "the suite expects a value of '" + expectation.first + "', which the test application does not know");
      }
    }
  }
  ResultLine line(testCase_.no(), verdict_);
  for (const std::string& literal : testCase_.literals()) {
    line.value(literal);
  }
  for (const auto& [output, literal] : testCase_.expectations()) {
    line.output("expected", output, literal);
  }
  for (const auto& [output, literal] : actual_) {
    line.output("actual", actual_.size() > 1 ? std::string_view(output) : std::string_view(), literal);
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

std::string CaseResult::named(std::string_view output, const std::string& difference) const {
  return testCase_.expectations().size() > 1 ? std::string(output) + ": " + difference : difference;
}

void CaseResult::worsen(Verdict verdict, std::string_view reason) {
  if (verdict > verdict_) {
    verdict_ = verdict;
  }
  message_ += message_.empty() ? "" : "; ";
  message_ += reason;
}

}  // namespace sitaf::suite
