#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sitaf/suite/literals.hpp"

namespace sitaf::suite {

/// One test case: values by the names of the suite's parameters, and what is expected of the outputs.
class TestCase {
 public:
  using Names = std::shared_ptr<const std::vector<std::string>>;
  /// Output and literal; the empty output stands for the only one.
  using Expectations = std::vector<std::pair<std::string, std::string>>;

  TestCase(int no, bool valid, Names names, std::vector<std::string> values, Expectations expectations)
      : no_(no), valid_(valid), names_(std::move(names)), values_(std::move(values)), expectations_(std::move(expectations)) {}

  /// Its number in the suite.
  int no() const { return no_; }

  /// Whether it holds no invalid value.
  bool valid() const { return valid_; }

  /// Whether the suite has such a parameter.
  bool has(std::string_view parameter) const;

  /// The value of a parameter as the suite spells it; CaseDataError where the suite has no such parameter.
  const std::string& literal(std::string_view parameter) const;

  /// The value of a parameter; CaseDataError where the suite has no such parameter, or the type cannot hold its value.
  template <class T>
  T value(std::string_view parameter) const {
    const std::string& spelled = literal(parameter);
    try {
      return literals::read<T>(spelled);
    } catch (const CaseDataError& e) {
      throw CaseDataError(std::string(parameter) + ": " + e.what());
    }
  }

  /// What is expected of an output; null when nothing is.
  const std::string* expected(std::string_view output) const;

  /// All literals in the suite's order.
  const std::vector<std::string>& literals() const { return values_; }

  const Expectations& expectations() const { return expectations_; }

 private:
  int no_;
  bool valid_;
  Names names_;
  std::vector<std::string> values_;
  Expectations expectations_;
};

}  // namespace sitaf::suite
