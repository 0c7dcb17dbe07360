#include "navigation_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sitaf/interfaces/NoEcho.hpp"

namespace robot {

using sitaf::interfaces::Decision;

sitaf::interfaces::Decision NavigationStep::Step(double desiredSpeed, double& commanded) {
  const double first = look();
  const double ahead = std::min(first, look());
  if (ahead < safeDistance_) {
    wheels_.Stop();
    commanded = 0;
    return Decision::HALT;
  }
  const bool near = ahead < 2 * safeDistance_;
  commanded = near ? std::min(desiredSpeed, 0.3) : desiredSpeed;
  wheels_.Drive(commanded);
  return near ? Decision::SLOW_DOWN : Decision::GO;
}

double NavigationStep::look() {
  try {
    const double range = finder_.GetRange();
    return std::isnan(range) ? std::numeric_limits<double>::infinity() : range;
  } catch (const sitaf::interfaces::NoEcho&) {
    return 0;
  }
}

}  // namespace robot
