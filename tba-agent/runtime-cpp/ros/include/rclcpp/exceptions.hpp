#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace rclcpp {
namespace exceptions {

class InvalidNodeError : public std::runtime_error
{
public:
  InvalidNodeError()
  : std::runtime_error("node is invalid") {}
};
class NameValidationError : public std::invalid_argument
{
public:
  NameValidationError(const std::string & type, const std::string & given, const std::string & why, std::size_t at = 0)
  : std::invalid_argument("Invalid " + type + ": " + why + ": '" + given + "'"), name_type(type), name(given),
    error_msg(why), invalid_index(at) {}
  const std::string name_type, name, error_msg;
  const std::size_t invalid_index;
};
#define SITAF_NAME_ERROR(name, text) \
  class name : public NameValidationError \
  { \
  public: \
    name(const std::string & given, const std::string & why, std::size_t at = 0) \
    : NameValidationError(text, given, why, at) {} \
  }
SITAF_NAME_ERROR(InvalidNodeNameError, "node name");
SITAF_NAME_ERROR(InvalidNamespaceError, "namespace");
SITAF_NAME_ERROR(InvalidTopicNameError, "topic name");
SITAF_NAME_ERROR(InvalidServiceNameError, "service name");
#undef SITAF_NAME_ERROR

#define SITAF_ERROR(name, base) \
  class name : public base \
  { \
  public: \
    explicit name(const std::string & text) \
    : base(text) {} \
  }
SITAF_ERROR(UnimplementedError, std::runtime_error);
SITAF_ERROR(InvalidEventError, std::runtime_error);
SITAF_ERROR(EventNotRegisteredError, std::runtime_error);
SITAF_ERROR(UnsupportedEventTypeException, std::runtime_error);
SITAF_ERROR(InvalidParametersException, std::runtime_error);
SITAF_ERROR(InvalidParameterValueException, std::runtime_error);
SITAF_ERROR(ParameterNotDeclaredException, std::runtime_error);
SITAF_ERROR(ParameterAlreadyDeclaredException, std::runtime_error);
SITAF_ERROR(ParameterImmutableException, std::runtime_error);
SITAF_ERROR(ParameterModifiedInCallbackException, std::runtime_error);
SITAF_ERROR(NoParameterOverrideProvided, std::runtime_error);
SITAF_ERROR(RCLError, std::runtime_error);
SITAF_ERROR(RCLBadAlloc, std::runtime_error);
SITAF_ERROR(RCLInvalidArgument, std::invalid_argument);
SITAF_ERROR(RCLInvalidROSArgsError, std::runtime_error);
SITAF_ERROR(UnknownROSArgsError, std::runtime_error);
SITAF_ERROR(UnknownTypeError, std::runtime_error);
SITAF_ERROR(QoSCheckCompatibleException, std::runtime_error);
SITAF_ERROR(InvalidServiceTypeError, std::runtime_error);
#undef SITAF_ERROR

class InvalidParameterTypeException : public std::runtime_error
{
public:
  InvalidParameterTypeException(const std::string & name, const std::string & message)
  : std::runtime_error("parameter '" + name + "' has invalid type: " + message) {}
};
class ParameterUninitializedException : public std::runtime_error
{
public:
  explicit ParameterUninitializedException(const std::string & name)
  : std::runtime_error("parameter '" + name + "' is not initialized") {}
};

}  // namespace exceptions
}  // namespace rclcpp
