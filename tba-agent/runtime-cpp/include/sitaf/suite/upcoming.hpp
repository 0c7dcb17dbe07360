#pragma once

#include <cstddef>

#include "sitaf/suite/test_case.hpp"

namespace sitaf::suite {

/// Access to the following cases, to prepare several at once.
class Upcoming {
 public:
  virtual ~Upcoming() = default;

  /// The current case (0), the next (1), and so on; null after the last case and after an error in the suite.
  virtual const TestCase* peek(std::size_t ahead) = 0;
};

}  // namespace sitaf::suite
