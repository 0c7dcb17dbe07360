// Parameters as text, and the log.
#include <cstdarg>
#include <cstdio>
#include <map>
#include <sstream>

#include "case.hpp"
#include "rclcpp/logger.hpp"
#include "rclcpp/parameter.hpp"

namespace rclcpp {

std::string to_string(ParameterType type)
{
  static const char * const names[] = {"not set", "bool", "integer", "double", "string", "byte_array", "bool_array",
    "integer_array", "double_array", "string_array"};
  return type <= PARAMETER_STRING_ARRAY ? names[type] : "unknown type";
}

std::ostream & operator<<(std::ostream & out, ParameterType type) {return out << to_string(type);}

namespace {

template<class T>
std::string listed(const std::vector<T> & values, const char * quote = "")
{
  std::ostringstream out;
  out << "[";
  bool first = true;
  for (const auto & value : values) {
    out << (first ? "" : ", ") << quote << std::boolalpha << value << quote;
    first = false;
  }
  out << "]";
  return out.str();
}

}  // namespace

std::string to_string(const ParameterValue & value)
{
  switch (value.get_type()) {
    case PARAMETER_NOT_SET: return "not set";
    case PARAMETER_BOOL: return value.get<bool>() ? "true" : "false";
    case PARAMETER_INTEGER: return std::to_string(value.get<std::int64_t>());
    case PARAMETER_DOUBLE: return std::to_string(value.get<double>());
    case PARAMETER_STRING: return value.get<std::string>();
    case PARAMETER_BYTE_ARRAY: {
        std::string text = "[";
        char byte[8];
        for (const auto item : value.get<std::vector<std::uint8_t>>()) {
          std::snprintf(byte, sizeof byte, "%s0x%02x", text.size() > 1 ? ", " : "", item);
          text += byte;
        }
        return text + "]";
      }
    case PARAMETER_BOOL_ARRAY: return listed(value.get<std::vector<bool>>());
    case PARAMETER_INTEGER_ARRAY: return listed(value.get<std::vector<std::int64_t>>());
    case PARAMETER_DOUBLE_ARRAY: return listed(value.get<std::vector<double>>());
    case PARAMETER_STRING_ARRAY: return listed(value.get<std::vector<std::string>>());
  }
  return "unknown type";
}

std::string to_string(const Parameter & parameter)
{
  return "{\"name\": \"" + parameter.get_name() + "\", \"type\": \"" + parameter.get_type_name() + "\", \"value\": \"" +
         parameter.value_to_string() + "\"}";
}

std::string to_string(const std::vector<Parameter> & parameters)
{
  std::string text = "{";
  for (const auto & parameter : parameters) {
    text += (text.size() > 1 ? ", " : "") + ("\"" + parameter.get_name() + "\": ") + to_string(parameter);
  }
  return text + "}";
}

std::ostream & operator<<(std::ostream & out, const Parameter & parameter) {return out << to_string(parameter);}
std::ostream & operator<<(std::ostream & out, const std::vector<Parameter> & parameters)
{
  return out << to_string(parameters);
}

}  // namespace rclcpp

namespace {

std::map<std::string, int> & levels()
{
  static std::map<std::string, int> levels;
  return levels;
}

}  // namespace

rcutils_ret_t rcutils_logging_set_logger_level(const char * name, int level)
{
  levels()[name == nullptr ? "" : name] = level;
  return 0;
}

int rcutils_logging_get_logger_level(const char * name)
{
  const auto found = levels().find(name == nullptr ? "" : name);
  return found == levels().end() ? RCUTILS_LOG_SEVERITY_UNSET : found->second;
}

int rcutils_logging_get_logger_effective_level(const char * name)
{
  std::string logger = name == nullptr ? "" : name;
  while (true) {
    const int level = rcutils_logging_get_logger_level(logger.c_str());
    if (level != RCUTILS_LOG_SEVERITY_UNSET) {
      return level;
    }
    if (logger.empty()) {
      return RCUTILS_LOG_SEVERITY_INFO;
    }
    const auto at = logger.rfind('.');
    logger = at == std::string::npos ? "" : logger.substr(0, at);
  }
}

bool rcutils_logging_logger_is_enabled_for(const char * name, int severity)
{
  return severity >= rcutils_logging_get_logger_effective_level(name);
}

namespace sitaf_ros {

void log(int severity, const char * logger, const char * format, ...)
{
  va_list arguments, again;
  va_start(arguments, format);
  va_copy(again, arguments);
  const int size = std::vsnprintf(nullptr, 0, format, arguments);
  va_end(arguments);
  std::string text(size < 0 ? 0 : static_cast<std::size_t>(size) + 1, '\0');
  std::vsnprintf(text.data(), text.size(), format, again);
  va_end(again);
  if (!text.empty()) {
    text.pop_back();
  }
  log_text(severity, logger, text);
}

void log_text(int severity, const char * logger, const std::string & text)
{
  if (!rcutils_logging_logger_is_enabled_for(logger, severity)) {
    return;
  }
  Event event{EventKind::LOG};
  event.number = severity;
  event.time = kernel::now();
  event.text = std::string(logger) + "\n" + text;
  Case::get().events.push_back(std::move(event));
}

Case & Case::get()
{
  static Case instance;
  return instance;
}

std::uint64_t Case::random(std::uint64_t below)
{
  // splitmix64, seeded by the order that the case asks for.
  state_ += 0x9e3779b97f4a7c15ull + (state_ == 0 ? static_cast<std::uint64_t>(callback_order) * 0xbf58476d1ce4e5b9ull : 0);
  std::uint64_t z = state_;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
  return (z ^ (z >> 31)) % below;
}

}  // namespace sitaf_ros
