#pragma once

#include <stdexcept>

namespace sitaf::interfaces {

/// The exception NoEcho of the interfaces.
class NoEcho : public std::runtime_error {
 public:
  NoEcho() : std::runtime_error("NoEcho") {}
  using std::runtime_error::runtime_error;
};

}  // namespace sitaf::interfaces
