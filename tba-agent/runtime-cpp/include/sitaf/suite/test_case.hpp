#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sitaf/suite/literals.hpp"

namespace sitaf::suite {

/// One test case: values by the names of the suite's parameters.
class TestCase {
 public:
  using Names = std::shared_ptr<const std::vector<std::string>>;

  TestCase(int no, bool valid, Names names, std::vector<std::string> values)
      : no_(no), valid_(valid), names_(std::move(names)), values_(std::move(values)) {}

  /// Its number in the suite.
  int no() const { return no_; }

  /// Whether it has no invalid value.
  bool valid() const { return valid_; }

  /// Whether the suite has such a parameter.
  bool has(std::string_view parameter) const;

  /// The literal of a parameter; throws CaseDataError when the suite has no such parameter.
  const std::string& literal(std::string_view parameter) const;

  /// The value of a parameter; throws CaseDataError when the suite has no such parameter or the type cannot hold its value.
  template <class T>
  T value(std::string_view parameter) const {
    const std::string& text = literal(parameter);
    try {
      return literals::read<T>(text);
    } catch (const CaseDataError& e) {
      throw CaseDataError(std::string(parameter) + ": " + e.what());
    }
  }

 private:
  int no_;
  bool valid_;
  Names names_;
  std::vector<std::string> values_;
};

}  // namespace sitaf::suite
