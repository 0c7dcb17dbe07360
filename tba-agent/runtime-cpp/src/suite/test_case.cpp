#include "sitaf/suite/test_case.hpp"

namespace sitaf::suite {

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
