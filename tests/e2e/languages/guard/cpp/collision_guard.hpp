#pragma once

#include <string>

#include "sitaf/hardware.hpp"
#include "sitaf/interfaces/Battery.hpp"
#include "sitaf/interfaces/NoContact.hpp"
#include "sitaf/interfaces/NotArmed.hpp"
#include "sitaf/interfaces/NotStopped.hpp"

namespace robot {

/// The guard of examples/collision-guard in C++.
class CollisionGuard {
 public:
  CollisionGuard(sitaf::Hardware& hardware, sitaf::interfaces::Battery& battery) : front_(hardware.rangeSensor("front")), battery_(battery) {}

  void Arm() { armed_ = true; }
  void Disarm() { armed_ = false; }

  std::string Check() {
    if (!armed_) {
      throw sitaf::interfaces::NotArmed();
    }
    stopped_ = stopped_ || front_.range() < 0.5;
    if (stopped_) {
      return "STOP";
    }
    return isLow() ? "LOW" : "CLEAR";
  }

  void Reset() {
    if (!stopped_) {
      throw sitaf::interfaces::NotStopped();
    }
    stopped_ = false;
  }

 private:
  bool isLow() {
    try {
      return battery_.Level() < 0.2;
    } catch (const sitaf::interfaces::NoContact&) {
      return true;
    }
  }

  sitaf::RangeSensor& front_;
  sitaf::interfaces::Battery& battery_;
  bool armed_ = false;
  bool stopped_ = false;
};

}  // namespace robot
