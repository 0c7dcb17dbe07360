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

/// Values as documents spell them: numbers in decimal, `NaN`, `Infinity` and `-Infinity`, `true` and `false`, strings as they are,
/// sequences as `[1.0, 2.5]` and structs as `{x: 1.0, y: 2.0}`, with strings inside of them in double quotes. Everything that cannot be
/// read is a CaseDataError.
namespace sitaf::suite::literals {

/// A floating-point number.
double real(std::string_view literal);

/// A whole number within bounds, both inclusive.
std::int64_t whole(std::string_view literal, std::int64_t min, std::int64_t max);

/// A whole number from 0 within a bound, inclusive.
std::uint64_t natural(std::string_view literal, std::uint64_t max);

bool truth(std::string_view literal);

char character(std::string_view literal);

/// The elements of `[a, b]`; a quoted element may hold commas, brackets and escaped quotes.
std::vector<std::string> elements(std::string_view literal);

/// The members of `{x: a, y: b}`, in their order.
std::vector<std::pair<std::string, std::string>> members(std::string_view literal);

/// The literal of a value.
std::string write(const Value& value);

/// The shortest digits that read back as the same number: in decimal notation from 1e-3 to below 1e7, otherwise with an exponent.
std::string write(double number);
std::string write(float number);

[[noreturn]] void refuse(std::string_view literal, std::string_view problem);

/// The value that a literal stands for.
template <class T>
T read(std::string_view literal) {
  if constexpr (std::is_same_v<T, bool>) {
    return truth(literal);
  } else if constexpr (std::is_same_v<T, char>) {
    return character(literal);
  } else if constexpr (std::is_enum_v<T>) {
    for (const auto& [name, value] : Enumeration<T>::literals) {
      if (name == literal) {
        return value;
      }
    }
    refuse(literal, "is not a literal of the enumeration");
  } else if constexpr (std::is_integral_v<T> && std::is_signed_v<T>) {
    return static_cast<T>(whole(literal, std::numeric_limits<T>::min(), std::numeric_limits<T>::max()));
  } else if constexpr (std::is_integral_v<T>) {
    return static_cast<T>(natural(literal, std::numeric_limits<T>::max()));
  } else if constexpr (std::is_floating_point_v<T>) {
    return static_cast<T>(real(literal));
  } else if constexpr (std::is_same_v<T, std::string>) {
    return std::string(literal);
  } else if constexpr (detail::IsSequence<T>::value) {
    const std::vector<std::string> spelled = elements(literal);
    T values{};
    if constexpr (std::is_same_v<T, std::vector<typename T::value_type>>) {
      values.reserve(spelled.size());
      for (const std::string& element : spelled) {
        values.push_back(read<typename T::value_type>(element));
      }
    } else {
      if (spelled.size() != values.size()) {
        refuse(literal, "has " + std::to_string(spelled.size()) + " elements, not " + std::to_string(values.size()));
      }
      for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = read<typename T::value_type>(spelled[i]);
      }
    }
    return values;
  } else {
    static_assert(detail::IsStructure<T>::value, "a test reads values of the interface's types");
    T value{};
    for (const auto& [member, spelled] : members(literal)) {
      bool known = false;
      Structure<T>::each(value, [&known, &wanted = member, &text = spelled](std::string_view name, auto& part) {
        if (name == wanted) {
          part = read<std::remove_reference_t<decltype(part)>>(text);
          known = true;
        }
      });
      if (!known) {
        refuse(literal, "has a member '" + member + "', which the struct does not have");
      }
    }
    return value;
  }
}

}  // namespace sitaf::suite::literals
