#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace sitaf::suite {

/// The members of a struct of the interface; generated for each. `each(value, visit)` calls `visit(name, member)` in the order of the
/// declaration.
template <class T>
struct Structure;

/// The literals of an enumeration of the interface; generated for each. `literals` is an array of pairs of name and value.
template <class T>
struct Enumeration;

/// A value of a component, independent of its C++ type, as it is written to documents.
class Value {
 public:
  using Elements = std::vector<Value>;
  using Members = std::vector<std::pair<std::string, Value>>;
  /// The name of an enumeration's literal, which is written without quotes.
  struct Literal {
    std::string name;
  };
  using Content = std::variant<bool, std::int64_t, std::uint64_t, float, double, std::string, Literal, Elements, Members>;

  Value(Content content) : content_(std::move(content)) {}

  const Content& content() const { return content_; }

 private:
  Content content_;
};

namespace detail {

template <class T, class = void>
struct IsStructure : std::false_type {};
template <class T>
struct IsStructure<T, std::void_t<decltype(sizeof(Structure<T>))>> : std::true_type {};

template <class T>
struct IsSequence : std::false_type {};
template <class E, class A>
struct IsSequence<std::vector<E, A>> : std::true_type {};
template <class E, std::size_t N>
struct IsSequence<std::array<E, N>> : std::true_type {};

}  // namespace detail

/// Converts a component's value: bool, numbers, char and strings, enumerations, sequences, arrays and structs.
template <class T>
Value valueOf(const T& value) {
  if constexpr (std::is_same_v<T, bool>) {
    return Value(Value::Content(value));
  } else if constexpr (std::is_same_v<T, char>) {
    return Value(Value::Content(std::string(1, value)));
  } else if constexpr (std::is_enum_v<T>) {
    for (const auto& [name, literal] : Enumeration<T>::literals) {
      if (literal == value) {
        return Value(Value::Content(Value::Literal{std::string(name)}));
      }
    }
    return Value(Value::Content(static_cast<std::int64_t>(value)));
  } else if constexpr (std::is_integral_v<T> && std::is_signed_v<T>) {
    return Value(Value::Content(static_cast<std::int64_t>(value)));
  } else if constexpr (std::is_integral_v<T>) {
    return Value(Value::Content(static_cast<std::uint64_t>(value)));
  } else if constexpr (std::is_same_v<T, float>) {
    return Value(Value::Content(value));
  } else if constexpr (std::is_floating_point_v<T>) {
    return Value(Value::Content(static_cast<double>(value)));
  } else if constexpr (std::is_convertible_v<const T&, std::string_view>) {
    return Value(Value::Content(std::string(std::string_view(value))));
  } else if constexpr (detail::IsSequence<T>::value) {
    Value::Elements elements;
    elements.reserve(value.size());
    for (auto&& element : value) {
      // The elements of a vector<bool> are proxies, which are converted to bool here.
      elements.push_back(valueOf<typename T::value_type>(element));
    }
    return Value(Value::Content(std::move(elements)));
  } else {
    static_assert(detail::IsStructure<T>::value, "a test compares values of the interface's types");
    Value::Members members;
    Structure<T>::each(value,
                       [&members](std::string_view name, const auto& member) { members.emplace_back(std::string(name), valueOf(member)); });
    return Value(Value::Content(std::move(members)));
  }
}

}  // namespace sitaf::suite
