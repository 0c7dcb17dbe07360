#pragma once

#include <stdexcept>

namespace sitaf::runtime {

/// The suite cannot be run at all, or cannot continue: the simulator is lost, an argument is wrong. The process ends with exit code 3;
/// nothing that a component under test does wrong belongs here. The message says what is missing and what to do, for a person.
class CannotRun : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace sitaf::runtime
