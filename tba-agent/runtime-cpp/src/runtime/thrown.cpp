#include "runtime/thrown.hpp"

#include <cxxabi.h>

#include <cstdlib>
#include <memory>
#include <typeinfo>
#include <utility>

namespace sitaf::runtime {
namespace {

constexpr int maxCauses = 3;

/// The thrown type; std::throw_with_nested wraps it in a template type.
std::string plainType(const char* name) {
  std::string type = demangled(name);
  const std::string nested = "std::_Nested_exception<";
  if (type.compare(0, nested.size(), nested) == 0) {
    type = type.substr(nested.size(), type.size() - nested.size() - 1);
  }
  return type;
}

}  // namespace

std::string simpleTypeOf(const std::exception_ptr& thrown) {
  std::string type;
  try {
    std::rethrow_exception(thrown);
  } catch (const std::exception& e) {
    type = plainType(typeid(e).name());
  } catch (...) {
    const std::type_info* info = abi::__cxa_current_exception_type();
    type = info == nullptr ? "" : plainType(info->name());
  }
  const auto scope = type.find('<') == std::string::npos ? type.rfind(':') : std::string::npos;
  return scope == std::string::npos ? type : type.substr(scope + 1);
}

std::string demangled(const char* name) {
  int status = 0;
  const std::unique_ptr<char, void (*)(void*)> plain(abi::__cxa_demangle(name, nullptr, nullptr, &status), std::free);
  return status == 0 ? plain.get() : name;
}

std::string describe(const std::exception_ptr& thrown) {
  std::string text;
  std::exception_ptr current = thrown;
  for (int depth = 0; current && depth <= maxCauses; ++depth) {
    text += depth == 0 ? "" : "; caused by ";
    try {
      std::rethrow_exception(std::exchange(current, nullptr));
    } catch (const std::exception& e) {
      const std::string what = e.what();
      const std::string type = plainType(typeid(e).name());
      text += type + (what.empty() ? "" : ": " + what);
      try {
        std::rethrow_if_nested(e);
      } catch (...) {
        current = std::current_exception();
      }
    } catch (...) {
      const std::type_info* type = abi::__cxa_current_exception_type();
      text += "an exception of type " + (type == nullptr ? std::string("unknown") : demangled(type->name()));
      try {
        throw;
      } catch (const char* message) {
        text += std::string(": ") + message;
      } catch (const std::string& message) {
        text += ": " + message;
      } catch (int code) {
        text += ": " + std::to_string(code);
      } catch (...) {
        // Only its type is known.
      }
    }
  }
  return text;
}

}  // namespace sitaf::runtime
