#pragma once

#include <cstddef>

#include "sitaf/suite/test_case.hpp"

namespace sitaf::suite {

/// The cases that follow, for those who prepare several at once.
class Upcoming {
 public:
  virtual ~Upcoming() = default;

  /// The case that runs now (0), the next (1), and so on; null behind the last, and where the suite cannot be read.
  virtual const TestCase* peek(std::size_t ahead) = 0;
};

}  // namespace sitaf::suite
