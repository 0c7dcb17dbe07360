#pragma once

#include <memory>
#include <string>

#include "rcutils/logging.h"

namespace rclcpp {

class Logger
{
public:
  enum class Level
  {
    Unset = RCUTILS_LOG_SEVERITY_UNSET, Debug = RCUTILS_LOG_SEVERITY_DEBUG, Info = RCUTILS_LOG_SEVERITY_INFO,
    Warn = RCUTILS_LOG_SEVERITY_WARN, Error = RCUTILS_LOG_SEVERITY_ERROR, Fatal = RCUTILS_LOG_SEVERITY_FATAL
  };

  explicit Logger(const std::string & name)
  : name_(std::make_shared<const std::string>(name)) {}
  const char * get_name() const {return name_->c_str();}
  Logger get_child(const std::string & suffix) const {return Logger(*name_ + "." + suffix);}
  void set_level(Level level) {rcutils_logging_set_logger_level(get_name(), static_cast<int>(level));}
  Level get_effective_level() const
  {
    return static_cast<Level>(rcutils_logging_get_logger_effective_level(get_name()));
  }
  Level get_level() const {return get_effective_level();}

private:
  std::shared_ptr<const std::string> name_;
};

inline Logger get_logger(const std::string & name) {return Logger(name);}

}  // namespace rclcpp
