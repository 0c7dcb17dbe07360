#pragma once

namespace sitaf::suite {

/// How a case ended. The agent, which knows the expected values, decides the verdict later.
enum class Outcome {
  /// The call returned, and its outputs are recorded.
  returned,
  /// The call under test threw an exception.
  threw,
  /// Anything else failed: creation, set-up, a periodic tick, a limit.
  error,
  /// The component was not called.
  notCalled
};

}  // namespace sitaf::suite
