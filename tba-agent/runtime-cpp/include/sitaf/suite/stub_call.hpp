#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace sitaf::suite {

/// A call that the component made of a required interface.
struct StubCall {
  /// `Interface.Method`
  std::string method;
  /// Name and literal of each parameter that carries something in.
  std::vector<std::pair<std::string, std::string>> arguments;
};

/// The calls of a case.
struct StubCalls {
  /// How many calls each method got; every method of a required interface is here.
  std::map<std::string, std::size_t> counts;
  /// The first calls, in their order.
  std::vector<StubCall> first;
};

}  // namespace sitaf::suite
