#include "arm.hpp"

#include <algorithm>
#include <chrono>

namespace robot {

Arm::Arm(sitaf::Hardware& hardware, sitaf::interfaces::Clock& clock)
    : hardware_(hardware), motor_(hardware.jointMotor("motor")), encoder_(hardware.jointEncoder("encoder")), clock_(clock) {}

double Arm::Swing(double effort) {
  const auto begun = hardware_.time();
  const double now = clock_.Now(swings_);
  ++swings_;
  motor_.setEffort(std::min(effort, most_));
  for (int i = 0; effort == 0 || i < 10; ++i) {
    hardware_.sleep(std::chrono::milliseconds(50));
    angles.push_back(encoder_.position());
  }
  motor_.setEffort(0);
  return std::chrono::duration<double>(hardware_.time() - begun).count() + now;
}

void Arm::Limit(double bound) {
  if (!initialised_) {
    throw std::logic_error("not initialised");
  }
  if (bound < 0 || bound > strongest_) {
    throw TooStrong();
  }
  most_ = bound;
}

sitaf::interfaces::ArmState Arm::state() const { return {encoder_.position(), swings_}; }

}  // namespace robot
