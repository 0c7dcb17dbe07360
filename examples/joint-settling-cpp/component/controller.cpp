#include "controller.hpp"

#include <algorithm>

namespace joint {

namespace {

/// Length of a period in seconds.
constexpr double dt = 0.01;

/// The largest torque of the motor in newton metres.
constexpr double strongest = 8;

/// How fast the integral follows the saturated output, in 1/s.
constexpr double tracking = 10;

}  // namespace

Controller::Controller(sitaf::Hardware& hardware)
    : motor_(hardware.jointMotor("motor")), encoder_(hardware.jointEncoder("encoder")) {}

void Controller::start() {
  target_ = encoder_.position();
}

void Controller::onExecute() {
  const double error = target_ - encoder_.position();
  const double wanted = kp_ * error + integral_ - kd_ * encoder_.velocity();
  const double effort = std::clamp(wanted, -strongest, strongest);
  integral_ += (ki_ * error + tracking * (effort - wanted)) * dt;
  motor_.setEffort(effort);
}

}  // namespace joint
