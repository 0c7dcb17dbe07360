#pragma once

#include <stdexcept>

namespace sitaf::suite {

/// A test case or the suite that holds it cannot be read; the message names the value and what was expected.
class CaseDataError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace sitaf::suite
