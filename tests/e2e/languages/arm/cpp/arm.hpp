#pragma once

#include <stdexcept>
#include <vector>

#include "sitaf/hardware.hpp"
#include "sitaf/interfaces/ArmState.hpp"
#include "sitaf/interfaces/Clock.hpp"

namespace robot {

class TooStrong : public std::runtime_error {
 public:
  TooStrong() : std::runtime_error("too strong") {}
};

class Arm {
 public:
  Arm(sitaf::Hardware& hardware, sitaf::interfaces::Clock& clock);

  void setStrongest(double effort) { strongest_ = effort; }
  void onInitialize() { initialised_ = true; }

  double Swing(double effort);
  void Watch(double effort) { Swing(effort); }
  void Limit(double bound);
  int start() { return ++starts_; }

  sitaf::interfaces::ArmState state() const;
  double getMost() const { return most_; }

  /// A data port may be a member.
  std::vector<double> angles;

 private:
  sitaf::Hardware& hardware_;
  sitaf::JointMotor& motor_;
  sitaf::JointEncoder& encoder_;
  sitaf::interfaces::Clock& clock_;
  double strongest_ = 1;
  double most_ = 0;
  int starts_ = 0;
  int swings_ = 0;
  bool initialised_ = false;
};

}  // namespace robot
