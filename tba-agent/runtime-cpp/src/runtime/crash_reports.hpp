#pragma once

namespace sitaf::runtime {

/// Installs handlers that print a stack trace when the process ends by a signal or by std::terminate: first the frames, then one line with
/// the cause and the component's innermost frame. The exit status does not change.
///
/// - coverage: saves the coverage; null when the component was not built for it
void installCrashHandlers(void (*coverage)());

/// Saves the coverage if the component was built for it, at most twice per second unless `end` is true.
void saveCoverage(bool end);

}  // namespace sitaf::runtime
