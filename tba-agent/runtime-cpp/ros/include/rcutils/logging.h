#pragma once

#include <cstdarg>
#include <cstddef>
#include <string>

enum RCUTILS_LOG_SEVERITY
{
  RCUTILS_LOG_SEVERITY_UNSET = 0, RCUTILS_LOG_SEVERITY_DEBUG = 10, RCUTILS_LOG_SEVERITY_INFO = 20,
  RCUTILS_LOG_SEVERITY_WARN = 30, RCUTILS_LOG_SEVERITY_ERROR = 40, RCUTILS_LOG_SEVERITY_FATAL = 50
};

typedef int rcutils_ret_t;
typedef int rcl_ret_t;
typedef int rmw_ret_t;
#define RCUTILS_RET_OK 0
#define RCL_RET_OK 0
#define RCL_RET_ERROR 1
#define RMW_RET_OK 0

rcutils_ret_t rcutils_logging_set_logger_level(const char * name, int level);
int rcutils_logging_get_logger_level(const char * name);
int rcutils_logging_get_logger_effective_level(const char * name);
bool rcutils_logging_logger_is_enabled_for(const char * name, int severity);
inline rcutils_ret_t rcutils_logging_initialize() {return 0;}
inline rcutils_ret_t rcutils_logging_shutdown() {return 0;}
inline void rcutils_reset_error() {}
inline void rcl_reset_error() {}

namespace sitaf_ros {

/// Writes a line of the log of a node.
void log(int severity, const char * logger, const char * format, ...) __attribute__((format(printf, 3, 4)));
void log_text(int severity, const char * logger, const std::string & text);

}  // namespace sitaf_ros
