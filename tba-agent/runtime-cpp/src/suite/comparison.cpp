#include "suite/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "sitaf/suite/literals.hpp"

namespace sitaf::suite {
namespace {

using literals::spelling;

std::string unequal(std::string_view expected, const Value& actual) {
  const bool text = std::holds_alternative<std::string>(actual.content()) || std::holds_alternative<Value::Literal>(actual.content());
  const std::string quote = text ? "'" : "";
  return "expected " + quote + std::string(expected) + quote + ", but was " + quote + spelling(actual) + quote;
}

/// The distance from a number to the next of its type, away from 0.
template <class Number>
double unitOf(Number number) {
  const Number size = std::abs(number);
  const Number next = std::nextafter(size, std::numeric_limits<Number>::infinity());
  // Beyond the largest number there is none; the distance below it is the same.
  return std::isfinite(next) ? static_cast<double>(next) - static_cast<double>(size)
                             : static_cast<double>(size) - static_cast<double>(std::nextafter(size, Number{0}));
}

std::string outside(std::string_view literal, const Value& actual, double apart, double allowed, const Tolerance& tolerance) {
  const std::string text = "expected " + std::string(literal) + ", but was " + spelling(actual);
  if (tolerance.isExact()) {
    return text;
  }
  return text + " (differs by " + spelling(apart) + ", allowed " + spelling(allowed) + ")";
}

template <class Number>
std::string realDifference(std::string_view literal, Number actual, const Value& value, const Tolerance& tolerance) {
  const auto expected = static_cast<Number>(literals::real(literal));
  if ((std::isnan(expected) && std::isnan(actual)) || expected == actual) {
    return "";
  }
  if (!std::isfinite(expected) || !std::isfinite(actual)) {
    return unequal(literal, value);
  }
  const double apart = std::abs(static_cast<double>(actual) - static_cast<double>(expected));
  const double allowed =
      tolerance.absolute + tolerance.relative * std::abs(static_cast<double>(expected)) + tolerance.ulp * unitOf(expected);
  return apart <= allowed ? "" : outside(literal, value, apart, allowed, tolerance);
}

/// A long double of the machines that SITAF knows holds every whole number of 64 bits.
template <class Number>
std::string wholeDifference(std::string_view literal, Number actual, const Value& value, const Tolerance& tolerance) {
  if (!std::isfinite(literals::real(literal))) {
    return unequal(literal, value);
  }
  const std::string text(literal);
  const long double expected = std::strtold(text.c_str(), nullptr);
  const long double apart = std::fabs(static_cast<long double>(actual) - expected);
  const long double allowed = tolerance.absolute + tolerance.relative * std::fabs(expected);
  return apart <= allowed ? "" : outside(literal, value, static_cast<double>(apart), static_cast<double>(allowed), tolerance);
}

std::string differenceAt(const std::string& path, std::string_view expected, const Value& actual, const Tolerance& tolerance);

std::string at(const std::string& path, std::string found) { return path.empty() || found.empty() ? found : path + ": " + found; }

std::string elementDifference(const std::string& path, std::string_view literal, const Value::Elements& actual,
                              const Tolerance& tolerance) {
  const auto expected = literals::elements(literal);
  for (std::size_t i = 0; i < std::min(expected.size(), actual.size()); ++i) {
    const std::string found = differenceAt(path + "[" + std::to_string(i) + "]", expected[i], actual[i], tolerance);
    if (!found.empty()) {
      return found;
    }
  }
  return expected.size() == actual.size()
             ? ""
             : at(path, "expected " + std::to_string(expected.size()) + " elements, but there are " + std::to_string(actual.size()));
}

std::string memberDifference(const std::string& path, std::string_view literal, const Value::Members& actual, const Tolerance& tolerance) {
  for (const auto& [name, spelled] : literals::members(literal)) {
    const std::string memberPath = path.empty() ? name : path + "." + name;
    bool known = false;
    for (const auto& [actualName, value] : actual) {
      if (actualName == name) {
        known = true;
        const std::string found = differenceAt(memberPath, spelled, value, tolerance);
        if (!found.empty()) {
          return found;
        }
      }
    }
    if (!known) {
      return at(memberPath, "expected " + spelled + ", but there is no such member");
    }
  }
  return "";
}

std::string differenceAt(const std::string& path, std::string_view expected, const Value& actual, const Tolerance& tolerance) {
  return std::visit(
      [&](const auto& content) -> std::string {
        using T = std::decay_t<decltype(content)>;
        if constexpr (std::is_same_v<T, bool>) {
          return literals::truth(expected) == content ? "" : at(path, unequal(expected, actual));
        } else if constexpr (std::is_same_v<T, float>) {
          return at(path, realDifference(expected, content, actual, tolerance));
        } else if constexpr (std::is_same_v<T, double>) {
          return at(path, realDifference(expected, content, actual, tolerance));
        } else if constexpr (std::is_integral_v<T>) {
          return at(path, wholeDifference(expected, content, actual, tolerance));
        } else if constexpr (std::is_same_v<T, Value::Elements>) {
          return elementDifference(path, expected, content, tolerance);
        } else if constexpr (std::is_same_v<T, Value::Members>) {
          return memberDifference(path, expected, content, tolerance);
        } else {
          return spelling(actual) == expected ? "" : at(path, unequal(expected, actual));
        }
      },
      actual.content());
}

}  // namespace

std::string difference(std::string_view expected, const Value& actual, const Tolerance& tolerance) {
  return differenceAt("", expected, actual, tolerance);
}

}  // namespace sitaf::suite
