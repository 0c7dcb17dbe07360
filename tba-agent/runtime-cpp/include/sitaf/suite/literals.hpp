#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "sitaf/suite/case_data_error.hpp"
#include "sitaf/suite/value.hpp"

/// Reads and writes literals (docs/test-application.md, Literals): numbers in decimal, `NaN`, `Infinity` and `-Infinity`, `true` and
/// `false`, strings without quotes, sequences as `[1.0, 2.5]` and structs as `{x: 1.0, y: 2.0}`, with nested strings in double quotes. A
/// literal that cannot be read throws CaseDataError.
namespace sitaf::suite::literals {

/// A floating-point number.
double real(std::string_view literal);

/// An integer within bounds, both inclusive.
std::int64_t whole(std::string_view literal, std::int64_t min, std::int64_t max);

/// An integer from 0 to a bound, inclusive.
std::uint64_t natural(std::string_view literal, std::uint64_t max);

bool boolean(std::string_view literal);

char character(std::string_view literal);

/// The elements of `[a, b]`, strings without their quotes.
std::vector<std::string> elements(std::string_view literal);

/// The members of `{x: a, y: b}` in their order, strings without their quotes.
std::vector<std::pair<std::string, std::string>> members(std::string_view literal);

/// The literal of a value.
std::string write(const Value& value);

/// The shortest text that is read back as the same number: in decimal notation from 1e-3 to below 1e7, otherwise with an exponent.
std::string write(double number);
std::string write(float number);

/// The literal without leading and trailing white space.
std::string_view stripped(std::string_view literal);

/// Throws a CaseDataError that quotes the literal.
[[noreturn]] void refuse(std::string_view literal, std::string_view problem);

/// The value of a literal.
template <class T>
T read(std::string_view literal) {
  if constexpr (std::is_same_v<T, bool>) {
    return boolean(literal);
  } else if constexpr (std::is_same_v<T, char>) {
    return character(literal);
  } else if constexpr (std::is_enum_v<T>) {
    std::string known;
    for (const auto& [name, value] : Enumeration<T>::literals) {
      if (name == stripped(literal)) {
        return value;
      }
      known += (known.empty() ? "" : ", ") + std::string(name);
    }
    refuse(literal, "is not one of " + known);
  } else if constexpr (std::is_integral_v<T> && std::is_signed_v<T>) {
    return static_cast<T>(whole(literal, std::numeric_limits<T>::min(), std::numeric_limits<T>::max()));
  } else if constexpr (std::is_integral_v<T>) {
    return static_cast<T>(natural(literal, std::numeric_limits<T>::max()));
  } else if constexpr (std::is_floating_point_v<T>) {
    return static_cast<T>(real(literal));
  } else if constexpr (std::is_same_v<T, std::string>) {
    return std::string(literal);
  } else if constexpr (detail::IsSequence<T>::value) {
    const std::vector<std::string> parts = elements(literal);
    T values{};
    if constexpr (std::is_same_v<T, std::vector<typename T::value_type>>) {
      values.reserve(parts.size());
      for (const std::string& element : parts) {
        values.push_back(read<typename T::value_type>(element));
      }
    } else {
      if (parts.size() != values.size()) {
        refuse(literal, "has " + std::to_string(parts.size()) + " elements, not " + std::to_string(values.size()));
      }
      for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = read<typename T::value_type>(parts[i]);
      }
    }
    return values;
  } else {
    static_assert(detail::IsStructure<T>::value, "a test reads values of the interface's types");
    T value{};
    for (const auto& [member, given] : members(literal)) {
      bool known = false;
      Structure<T>::each(value, [&known, &wanted = member, &text = given](std::string_view name, auto& part) {
        if (name == wanted) {
          part = read<std::remove_reference_t<decltype(part)>>(text);
          known = true;
        }
      });
      if (!known) {
        std::string names;
        Structure<T>::each(value,
                           [&names](std::string_view name, auto& /*part*/) { names += (names.empty() ? "" : ", ") + std::string(name); });
        refuse(literal, "has an unknown member " + member + "; the struct has " + names);
      }
    }
    return value;
  }
}

}  // namespace sitaf::suite::literals
