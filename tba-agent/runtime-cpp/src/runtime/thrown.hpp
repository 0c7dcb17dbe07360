#pragma once

#include <exception>
#include <string>

namespace sitaf::runtime {

/// Says in one message what was thrown: type and `what()`, of the exception and of those nested in it. Only inside of a catch block does it
/// know the type of what is no std::exception.
std::string describe(const std::exception_ptr& thrown);

/// The name of the thrown type without its scope, such as `NoEcho`.
std::string simpleTypeOf(const std::exception_ptr& thrown);

/// The name of a type or symbol as it is written in C++.
std::string demangled(const char* name);

}  // namespace sitaf::runtime
