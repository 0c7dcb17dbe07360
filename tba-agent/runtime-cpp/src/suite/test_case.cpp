#include "sitaf/suite/test_case.hpp"

namespace sitaf::suite {

TestCase::TestCase(int no, bool valid, Names names, std::vector<std::string> values, std::vector<TestStep> steps)
    : no_(no),
      valid_(valid),
      names_(std::move(names)),
      values_(std::move(values)),
      steps_(std::make_shared<const std::vector<TestStep>>(std::move(steps))) {}

const std::vector<TestStep>& TestCase::steps() const {
  static const std::vector<TestStep> none;
  return steps_ == nullptr ? none : *steps_;
}

bool TestCase::has(std::string_view parameter) const {
  for (const std::string& name : *names_) {
    if (name == parameter) {
      return true;
    }
  }
  return false;
}

const std::string& TestCase::literal(std::string_view parameter) const {
  for (std::size_t i = 0; i < names_->size(); ++i) {
    if ((*names_)[i] == parameter) {
      return values_[i];
    }
  }
  std::string existing;
  for (const std::string& name : *names_) {
    existing += (existing.empty() ? "" : ", ") + name;
  }
  throw CaseDataError("the suite has no parameter '" + std::string(parameter) + "'; it has [" + existing +
                      "]: generate the test application again");
}

}  // namespace sitaf::suite
