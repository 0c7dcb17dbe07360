#pragma once

#include <cstdint>
#include <ostream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "rcl_interfaces/msg/parameter_type.hpp"
#include "rcl_interfaces/msg/parameter_value.hpp"

namespace rclcpp {

enum ParameterType : std::uint8_t
{
  PARAMETER_NOT_SET, PARAMETER_BOOL, PARAMETER_INTEGER, PARAMETER_DOUBLE, PARAMETER_STRING, PARAMETER_BYTE_ARRAY,
  PARAMETER_BOOL_ARRAY, PARAMETER_INTEGER_ARRAY, PARAMETER_DOUBLE_ARRAY, PARAMETER_STRING_ARRAY
};

std::string to_string(ParameterType type);
std::ostream & operator<<(std::ostream & out, ParameterType type);

class ParameterTypeException : public std::runtime_error
{
public:
  ParameterTypeException(ParameterType expected, ParameterType actual)
  : std::runtime_error("expected [" + to_string(expected) + "] got [" + to_string(actual) + "]") {}
};

namespace detail {

template<class T, class = void>
struct ParameterOf;
#define SITAF_PARAMETER(cpp, type, member) \
  template<> \
  struct ParameterOf<cpp> \
  { \
    static constexpr ParameterType kind = type; \
    static auto & value(rcl_interfaces::msg::ParameterValue & v) {return v.member;} \
    static const auto & value(const rcl_interfaces::msg::ParameterValue & v) {return v.member;} \
  }
SITAF_PARAMETER(bool, PARAMETER_BOOL, bool_value);
SITAF_PARAMETER(std::string, PARAMETER_STRING, string_value);
SITAF_PARAMETER(std::vector<std::uint8_t>, PARAMETER_BYTE_ARRAY, byte_array_value);
SITAF_PARAMETER(std::vector<bool>, PARAMETER_BOOL_ARRAY, bool_array_value);
SITAF_PARAMETER(std::vector<std::int64_t>, PARAMETER_INTEGER_ARRAY, integer_array_value);
SITAF_PARAMETER(std::vector<double>, PARAMETER_DOUBLE_ARRAY, double_array_value);
SITAF_PARAMETER(std::vector<std::string>, PARAMETER_STRING_ARRAY, string_array_value);
#undef SITAF_PARAMETER
template<class T>
struct ParameterOf<T, std::enable_if_t<std::is_integral_v<T> && !std::is_same_v<T, bool>>>
{
  static constexpr ParameterType kind = PARAMETER_INTEGER;
  static const auto & value(const rcl_interfaces::msg::ParameterValue & v) {return v.integer_value;}
};
template<class T>
struct ParameterOf<T, std::enable_if_t<std::is_floating_point_v<T>>>
{
  static constexpr ParameterType kind = PARAMETER_DOUBLE;
  static const auto & value(const rcl_interfaces::msg::ParameterValue & v) {return v.double_value;}
};
template<class T>
struct ParameterOf<std::vector<T>, std::enable_if_t<
    std::is_integral_v<T> && !std::is_same_v<T, bool> && !std::is_same_v<T, std::uint8_t> &&
    !std::is_same_v<T, std::int64_t>>>
{
  static constexpr ParameterType kind = PARAMETER_INTEGER_ARRAY;
  static std::vector<T> value(const rcl_interfaces::msg::ParameterValue & v)
  {
    return {v.integer_array_value.begin(), v.integer_array_value.end()};
  }
};
template<>
struct ParameterOf<std::vector<float>>
{
  static constexpr ParameterType kind = PARAMETER_DOUBLE_ARRAY;
  static std::vector<float> value(const rcl_interfaces::msg::ParameterValue & v)
  {
    return {v.double_array_value.begin(), v.double_array_value.end()};
  }
};

template<ParameterType>
struct TypeOf;
template<>
struct TypeOf<PARAMETER_BOOL> {using type = bool;};
template<>
struct TypeOf<PARAMETER_INTEGER> {using type = std::int64_t;};
template<>
struct TypeOf<PARAMETER_DOUBLE> {using type = double;};
template<>
struct TypeOf<PARAMETER_STRING> {using type = std::string;};
template<>
struct TypeOf<PARAMETER_BYTE_ARRAY> {using type = std::vector<std::uint8_t>;};
template<>
struct TypeOf<PARAMETER_BOOL_ARRAY> {using type = std::vector<bool>;};
template<>
struct TypeOf<PARAMETER_INTEGER_ARRAY> {using type = std::vector<std::int64_t>;};
template<>
struct TypeOf<PARAMETER_DOUBLE_ARRAY> {using type = std::vector<double>;};
template<>
struct TypeOf<PARAMETER_STRING_ARRAY> {using type = std::vector<std::string>;};

}  // namespace detail

class ParameterValue
{
public:
  ParameterValue() = default;
  explicit ParameterValue(const rcl_interfaces::msg::ParameterValue & value)
  : value_(value) {}
  explicit ParameterValue(bool value) {put(value);}
  explicit ParameterValue(int value) {set(value);}
  explicit ParameterValue(std::int64_t value) {set(value);}
  explicit ParameterValue(unsigned value) {set(value);}
  explicit ParameterValue(std::uint64_t value) {set(static_cast<std::int64_t>(value));}
  explicit ParameterValue(long long value) {set(static_cast<std::int64_t>(value));}
  explicit ParameterValue(float value) {set(static_cast<double>(value));}
  explicit ParameterValue(double value) {set(value);}
  explicit ParameterValue(const std::string & value) {put(value);}
  explicit ParameterValue(const char * value) {put(std::string(value));}
  explicit ParameterValue(const std::vector<std::uint8_t> & value) {put(value);}
  explicit ParameterValue(const std::vector<bool> & value) {put(value);}
  explicit ParameterValue(const std::vector<int> & value)
  {
    put(std::vector<std::int64_t>(value.begin(), value.end()));
  }
  explicit ParameterValue(const std::vector<std::int64_t> & value) {put(value);}
  explicit ParameterValue(const std::vector<float> & value) {put(std::vector<double>(value.begin(), value.end()));}
  explicit ParameterValue(const std::vector<double> & value) {put(value);}
  explicit ParameterValue(const std::vector<std::string> & value) {put(value);}

  ParameterType get_type() const {return static_cast<ParameterType>(value_.type);}
  rcl_interfaces::msg::ParameterValue to_value_msg() const {return value_;}

  bool operator==(const ParameterValue & other) const {return value_ == other.value_;}
  bool operator!=(const ParameterValue & other) const {return !(*this == other);}

  template<class T>
  decltype(auto) get() const
  {
    using Of = detail::ParameterOf<std::decay_t<T>>;
    if (get_type() != Of::kind) {
      throw ParameterTypeException(Of::kind, get_type());
    }
    return Of::value(value_);
  }
  template<ParameterType type>
  decltype(auto) get() const {return get<typename detail::TypeOf<type>::type>();}

private:
  template<class T>
  void put(const T & value)
  {
    value_.type = detail::ParameterOf<T>::kind;
    detail::ParameterOf<T>::value(value_) = value;
  }
  void set(std::int64_t value)
  {
    value_.type = PARAMETER_INTEGER;
    value_.integer_value = value;
  }
  void set(int value) {set(static_cast<std::int64_t>(value));}
  void set(unsigned value) {set(static_cast<std::int64_t>(value));}
  void set(double value)
  {
    value_.type = PARAMETER_DOUBLE;
    value_.double_value = value;
  }

  rcl_interfaces::msg::ParameterValue value_;
};

std::string to_string(const ParameterValue & value);

}  // namespace rclcpp
