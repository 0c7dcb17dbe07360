#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace sitaf::suite {

/// A call of the component to a required interface.
struct StubCall {
  /// `Interface.Method`
  std::string method;
  /// Name and literal of each input parameter.
  std::vector<std::pair<std::string, std::string>> arguments;
};

/// The calls of a case.
struct StubCalls {
  /// Number of calls of each method, for all methods of required interfaces.
  std::map<std::string, std::size_t> counts;
  /// The first calls, in order.
  std::vector<StubCall> first;
};

}  // namespace sitaf::suite
