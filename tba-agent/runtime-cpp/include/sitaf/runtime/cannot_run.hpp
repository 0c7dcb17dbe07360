#pragma once

#include <stdexcept>

namespace sitaf::runtime {

/// The suite cannot run or cannot continue, for example because the simulator is lost or an argument is wrong. The process ends with exit
/// code 3. Failures of the component under test never throw this. The message says what is missing and what the user can do.
class CannotRun : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace sitaf::runtime
