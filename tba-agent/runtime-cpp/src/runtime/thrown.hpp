#pragma once

#include <exception>
#include <string>

namespace sitaf::runtime {

/// Describes an exception in one message: type and `what()`, also of nested exceptions. The type of an object that is no std::exception is
/// known only within a catch block.
std::string describe(const std::exception_ptr& thrown);

/// The name of the thrown type without its scope, such as `NoEcho`.
std::string simpleTypeOf(const std::exception_ptr& thrown);

/// The name of a type or symbol as it is written in C++.
std::string demangled(const char* name);

}  // namespace sitaf::runtime
