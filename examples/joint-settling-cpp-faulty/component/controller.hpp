#pragma once

#include "sitaf/hardware.hpp"

namespace joint {

/// Holds a joint at an angle: a PID controller with back-calculation, which takes from the integral
/// what the motor cannot give.
class Controller {
 public:
  /// Uses the motor `motor` and the encoder `encoder`.
  explicit Controller(sitaf::Hardware& hardware);

  void setKp(double gain) { kp_ = gain; }
  void setKi(double gain) { ki_ = gain; }
  void setKd(double gain) { kd_ = gain; }

  /// Holds the initial angle until a target is set.
  void start();

  /// The angle to hold from now on, in radians.
  void SetTarget(double angle) { target_ = angle; }

  /// One period of 10 ms.
  void onExecute();

 private:
  sitaf::JointMotor& motor_;
  sitaf::JointEncoder& encoder_;
  double kp_ = 0;
  double ki_ = 0;
  double kd_ = 0;
  double target_ = 0;
  double integral_ = 0;
};

}  // namespace joint
