#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sitaf/suite/literals.hpp"

namespace sitaf::suite {

class TestStep;

/// One test case: values by the names of the suite's parameters.
class TestCase {
 public:
  using Names = std::shared_ptr<const std::vector<std::string>>;

  TestCase(int no, bool valid, Names names, std::vector<std::string> values)
      : no_(no), valid_(valid), names_(std::move(names)), values_(std::move(values)) {}

  /// A case that is a sequence of calls and events; the values are the initial ones.
  TestCase(int no, bool valid, Names names, std::vector<std::string> values, std::vector<TestStep> steps);

  /// The steps of a sequence; none if the case is a single call.
  const std::vector<TestStep>& steps() const;

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
  std::shared_ptr<const std::vector<TestStep>> steps_;
};

/// A step of a sequence: a call with its values, or an event without values.
class TestStep : public TestCase {
 public:
  /// `no` is the number of the case, `number` that of the step in it, from 1.
  TestStep(int no, int number, std::string name, bool valid, Names names, std::vector<std::string> values)
      : TestCase(no, valid, std::move(names), std::move(values)), number_(number), name_(std::move(name)) {}

  /// Its number in the case, from 1.
  int number() const { return number_; }

  /// The call or event of the test model.
  const std::string& name() const { return name_; }

 private:
  int number_;
  std::string name_;
};

}  // namespace sitaf::suite
