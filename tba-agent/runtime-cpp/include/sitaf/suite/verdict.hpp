#pragma once

namespace sitaf::suite {

/// How a case ended; from good to bad.
enum class Verdict {
  /// As expected, or nothing was expected and the call returned.
  pass,
  /// An output has a wrong value.
  fail,
  /// The component threw an exception, or the case could not be judged.
  error,
  /// The component was not called; the message says why.
  dont
};

}  // namespace sitaf::suite
