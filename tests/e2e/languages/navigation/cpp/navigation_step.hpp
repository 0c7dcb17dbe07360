#pragma once

#include "sitaf/interfaces/Decision.hpp"
#include "sitaf/interfaces/RangeFinder.hpp"
#include "sitaf/interfaces/WheelController.hpp"

namespace robot {

/// The step of examples/navigation-step in C++.
class NavigationStep {
 public:
  NavigationStep(sitaf::interfaces::RangeFinder& finder, sitaf::interfaces::WheelController& wheels) : finder_(finder), wheels_(wheels) {}

  void setSafeDistance(double metres) { safeDistance_ = metres; }

  sitaf::interfaces::Decision Step(double desiredSpeed, double& commanded);

 private:
  double look();

  sitaf::interfaces::RangeFinder& finder_;
  sitaf::interfaces::WheelController& wheels_;
  double safeDistance_ = 1.0;
};

}  // namespace robot
