#pragma once

namespace sitaf::runtime {

/// From now on a process that ends by a signal or by std::terminate says on its error stream where it was: frames first, and last one line
/// that names what happened and the component's innermost frame. How it ends stays as it is.
///
/// - coverage: writes out which lines were reached; null where the component was not built for it
void sayLastWords(void (*coverage)());

/// Writes coverage out, where the component was built for it; no more often than twice a second unless it is the end.
void keepCoverage(bool end);

}  // namespace sitaf::runtime
