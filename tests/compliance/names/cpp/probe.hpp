#pragma once

#include "sitaf/interfaces/Duration.hpp"

namespace robot {

/// Uses names of its interface that C++ does not allow.
class Probe {
 public:
  sitaf::interfaces::Duration Trace(const sitaf::interfaces::Duration& given, const sitaf::interfaces::Duration& whole);
};

}  // namespace robot
