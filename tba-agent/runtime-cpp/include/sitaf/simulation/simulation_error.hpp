#pragma once

#include <chrono>
#include <sstream>
#include <stdexcept>
#include <string>

namespace sitaf::simulation {

/// A call to the simulator failed.
class SimulationError : public std::runtime_error {
 public:
  SimulationError(const std::string& message, bool lost) : std::runtime_error(message), lost_(lost) {}

  /// Whether the simulator or the session is lost, so that no further case can run. Otherwise the simulator rejected one request, and the
  /// next may succeed.
  bool isLost() const { return lost_; }

 private:
  bool lost_;
};

/// A case exceeded its limit of simulation time.
class CaseTooLong : public std::runtime_error {
 public:
  explicit CaseTooLong(std::chrono::nanoseconds most) : std::runtime_error(message(std::chrono::duration<double>(most).count())) {}

 private:
  static std::string message(double seconds) {
    std::ostringstream text;
    text << "the case took more than " << seconds << " s of simulation time";
    return text.str();
  }
};

}  // namespace sitaf::simulation
