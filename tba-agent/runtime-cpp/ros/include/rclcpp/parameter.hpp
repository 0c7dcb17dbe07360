#pragma once

#include <map>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "rcl_interfaces/msg/parameter.hpp"
#include "rcl_interfaces/msg/parameter_descriptor.hpp"
#include "rclcpp/exceptions.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp/parameter_value.hpp"

namespace rclcpp {

class Parameter
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Parameter)

  Parameter() = default;
  explicit Parameter(const std::string & name)
  : name_(name) {}
  Parameter(const std::string & name, const ParameterValue & value)
  : name_(name), value_(value) {}
  template<class T, class = std::enable_if_t<!std::is_same_v<std::decay_t<T>, ParameterValue>>>
  Parameter(const std::string & name, const T & value)
  : name_(name), value_(value) {}

  static Parameter from_parameter_msg(const rcl_interfaces::msg::Parameter & message)
  {
    return {message.name, ParameterValue(message.value)};
  }
  rcl_interfaces::msg::Parameter to_parameter_msg() const
  {
    rcl_interfaces::msg::Parameter message;
    message.name = name_;
    message.value = value_.to_value_msg();
    return message;
  }

  bool operator==(const Parameter & other) const {return name_ == other.name_ && value_ == other.value_;}
  bool operator!=(const Parameter & other) const {return !(*this == other);}

  ParameterType get_type() const {return value_.get_type();}
  std::string get_type_name() const {return to_string(get_type());}
  const std::string & get_name() const {return name_;}
  rcl_interfaces::msg::ParameterValue get_value_message() const {return value_.to_value_msg();}
  const ParameterValue & get_parameter_value() const {return value_;}

  template<ParameterType type>
  decltype(auto) get_value() const {return value_.get<type>();}
  template<class T>
  decltype(auto) get_value() const
  {
    try {
      return value_.get<T>();
    } catch (const ParameterTypeException & e) {
      throw exceptions::InvalidParameterTypeException(name_, e.what());
    }
  }
  bool as_bool() const {return get_value<bool>();}
  std::int64_t as_int() const {return get_value<std::int64_t>();}
  double as_double() const {return get_value<double>();}
  const std::string & as_string() const {return get_value<std::string>();}
  const std::vector<std::uint8_t> & as_byte_array() const {return get_value<std::vector<std::uint8_t>>();}
  const std::vector<bool> & as_bool_array() const {return get_value<std::vector<bool>>();}
  const std::vector<std::int64_t> & as_integer_array() const {return get_value<std::vector<std::int64_t>>();}
  const std::vector<double> & as_double_array() const {return get_value<std::vector<double>>();}
  const std::vector<std::string> & as_string_array() const {return get_value<std::vector<std::string>>();}
  std::string value_to_string() const {return to_string(value_);}

private:
  std::string name_;
  ParameterValue value_;
};

std::ostream & operator<<(std::ostream & out, const Parameter & parameter);
std::ostream & operator<<(std::ostream & out, const std::vector<Parameter> & parameters);
std::string to_string(const Parameter & parameter);
std::string to_string(const std::vector<Parameter> & parameters);

using ParameterMap = std::map<std::string, std::vector<Parameter>>;

}  // namespace rclcpp
