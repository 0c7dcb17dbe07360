#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

namespace sitaf::runtime {

/// How a test application is started.
struct CommandLine {
  std::string suite;
  std::string results;
  /// gRPC target of the simulator and the world description; both or none.
  std::optional<std::string> bridge;
  std::optional<std::string> world;
  std::uint64_t seed = 1;
  /// The number of the first case to run; 0 for all.
  int from = 0;
  /// Where a file of each case goes that shows what moved in it; none where it is empty.
  std::string recording;
  /// Simulation time that one case may take.
  std::optional<std::chrono::nanoseconds> caseTime;

  /// Reads the arguments; CannotRun when they are wrong.
  static CommandLine parse(int argc, char** argv);
};

}  // namespace sitaf::runtime
