#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

namespace sitaf::runtime {

/// How the call of each case is repeated to measure its time.
struct Repetition {
  /// Repeated calls before the measured ones.
  int warmUp = 0;
  /// Measured calls.
  int repeat = 0;
  /// No further call begins when this time has passed since the case began.
  std::chrono::nanoseconds within = std::chrono::nanoseconds::max();
};

/// The command line of a test application.
struct CommandLine {
  std::string suite;
  std::string results;
  /// gRPC target of the simulator and the world description; both or neither.
  std::optional<std::string> bridge;
  std::optional<std::string> world;
  std::uint64_t seed = 1;
  /// The number of the first case to run; 0 for all.
  int from = 0;
  /// Folder for a recording of the motion in each case; empty for none.
  std::string recording;
  /// Maximum simulation time of a case.
  std::optional<std::chrono::nanoseconds> caseTime;
  /// How the call of each case is repeated to measure its time.
  std::optional<Repetition> repetition;

  /// Reads the arguments; throws CannotRun when they are wrong.
  static CommandLine parse(int argc, char** argv);
};

}  // namespace sitaf::runtime
