#pragma once

#include <algorithm>
#include <cmath>

#include "sitaf/hardware.hpp"

namespace robot {

/// The controller of examples/joint-pid in C++, all in its header.
class JointController {
 public:
  explicit JointController(sitaf::Hardware& hardware)
      : motor_(hardware.jointMotor("motor")), encoder_(hardware.jointEncoder("encoder")) {}

  void setKp(double gain) { kp_ = gain; }
  void setKi(double gain) { ki_ = gain; }
  void setKd(double gain) { kd_ = gain; }

  void start() { target_ = encoder_.position(); }
  void SetTarget(double angle) { target_ = angle; }
  double GetTime() const { return static_cast<double>(periods_) * period; }

  void onExecute() {
    ++periods_;
    const double error = target_ - encoder_.position();
    const double effort = kp_ * error + ki_ * (sum_ + error * period) - kd_ * encoder_.velocity();
    if (std::abs(effort) <= strongest) {
      sum_ += error * period;
    }
    motor_.setEffort(std::max(-strongest, std::min(strongest, effort)));
  }

 private:
  static constexpr double period = 0.01;
  static constexpr double strongest = 8;

  sitaf::JointMotor& motor_;
  sitaf::JointEncoder& encoder_;
  double kp_ = 0;
  double ki_ = 0;
  double kd_ = 0;
  double target_ = 0;
  double sum_ = 0;
  long periods_ = 0;
};

}  // namespace robot
