// The logging macros of rclcpp, rcutils and rclcpp's streams.
#pragma once

#include <functional>
#include <sstream>
#include <string>
#include <type_traits>

#include "rclcpp/clock.hpp"
#include "rclcpp/logger.hpp"

#define RCLCPP_FIRST_ARG(N, ...) N
#define RCLCPP_ALL_BUT_FIRST_ARGS(N, ...) __VA_ARGS__

namespace sitaf_ros {

inline const char * text_of(const char * text) {return text;}
inline const char * text_of(const std::string & text) {return text.c_str();}

}  // namespace sitaf_ros

// The call of `log` is written out, so that the compiler checks the format.
#define SITAF_LOG(severity, logger, ...) \
  do { \
    static_assert( \
      ::std::is_convertible_v<decltype(logger), ::rclcpp::Logger>, "First argument to logging macros must be an rclcpp::Logger"); \
    const ::rclcpp::Logger sitaf_logger_ = (logger); \
    if (rcutils_logging_logger_is_enabled_for(sitaf_logger_.get_name(), severity)) { \
      ::sitaf_ros::log(severity, sitaf_logger_.get_name(), __VA_ARGS__); \
    } \
  } while (0)
#define SITAF_LOG_STREAM(severity, logger, arguments) \
  do { \
    ::std::stringstream sitaf_stream_; \
    sitaf_stream_ << arguments; \
    ::sitaf_ros::log_text(severity, ::rclcpp::Logger(logger).get_name(), sitaf_stream_.str()); \
  } while (0)
#define SITAF_ONCE(call) \
  do { \
    static bool sitaf_done_ = false; \
    if (!sitaf_done_) { \
      sitaf_done_ = true; \
      call; \
    } \
  } while (0)
#define SITAF_SKIPFIRST(call) \
  do { \
    static bool sitaf_first_ = true; \
    if (sitaf_first_) { \
      sitaf_first_ = false; \
    } else { \
      call; \
    } \
  } while (0)
// Clock is a Clock, or a pointer to one.
#define SITAF_THROTTLE(clock, duration, call) \
  do { \
    static ::std::int64_t sitaf_last_ = INT64_MIN / 2; \
    const ::std::int64_t sitaf_now_ = ::sitaf_ros::clock_of(clock).now().nanoseconds(); \
    if (sitaf_now_ - sitaf_last_ >= static_cast<::std::int64_t>(duration) * 1000000) { \
      sitaf_last_ = sitaf_now_; \
      call; \
    } \
  } while (0)

namespace sitaf_ros {

inline rclcpp::Clock & clock_of(rclcpp::Clock & clock) {return clock;}
inline rclcpp::Clock & clock_of(const rclcpp::Clock & clock) {return const_cast<rclcpp::Clock &>(clock);}
inline rclcpp::Clock & clock_of(rclcpp::Clock * clock) {return *clock;}
inline rclcpp::Clock & clock_of(const std::shared_ptr<rclcpp::Clock> & clock) {return *clock;}

}  // namespace sitaf_ros

#define RCLCPP_DEBUG(logger, ...) SITAF_LOG(RCUTILS_LOG_SEVERITY_DEBUG, logger, __VA_ARGS__)
#define RCLCPP_DEBUG_ONCE(logger, ...) SITAF_ONCE(SITAF_LOG(RCUTILS_LOG_SEVERITY_DEBUG, logger, __VA_ARGS__))
#define RCLCPP_DEBUG_SKIPFIRST(logger, ...) SITAF_SKIPFIRST(SITAF_LOG(RCUTILS_LOG_SEVERITY_DEBUG, logger, __VA_ARGS__))
#define RCLCPP_DEBUG_EXPRESSION(logger, expression, ...) do {if (expression) {SITAF_LOG(RCUTILS_LOG_SEVERITY_DEBUG, logger, __VA_ARGS__);}} while (0)
#define RCLCPP_DEBUG_FUNCTION(logger, function, ...) do {if ((*function)()) {SITAF_LOG(RCUTILS_LOG_SEVERITY_DEBUG, logger, __VA_ARGS__);}} while (0)
#define RCLCPP_DEBUG_THROTTLE(logger, clock, duration, ...) SITAF_THROTTLE(clock, duration, SITAF_LOG(RCUTILS_LOG_SEVERITY_DEBUG, logger, __VA_ARGS__))
#define RCLCPP_DEBUG_SKIPFIRST_THROTTLE(logger, clock, duration, ...) SITAF_SKIPFIRST(SITAF_THROTTLE(clock, duration, SITAF_LOG(RCUTILS_LOG_SEVERITY_DEBUG, logger, __VA_ARGS__)))
#define RCLCPP_DEBUG_STREAM(logger, arguments) SITAF_LOG_STREAM(RCUTILS_LOG_SEVERITY_DEBUG, logger, arguments)
#define RCLCPP_DEBUG_STREAM_ONCE(logger, arguments) SITAF_ONCE(SITAF_LOG_STREAM(RCUTILS_LOG_SEVERITY_DEBUG, logger, arguments))
#define RCLCPP_DEBUG_STREAM_SKIPFIRST(logger, arguments) SITAF_SKIPFIRST(SITAF_LOG_STREAM(RCUTILS_LOG_SEVERITY_DEBUG, logger, arguments))
#define RCLCPP_DEBUG_STREAM_EXPRESSION(logger, expression, arguments) do {if (expression) {SITAF_LOG_STREAM(RCUTILS_LOG_SEVERITY_DEBUG, logger, arguments);}} while (0)
#define RCLCPP_DEBUG_STREAM_FUNCTION(logger, function, arguments) do {if ((*function)()) {SITAF_LOG_STREAM(RCUTILS_LOG_SEVERITY_DEBUG, logger, arguments);}} while (0)
#define RCLCPP_DEBUG_STREAM_THROTTLE(logger, clock, duration, arguments) SITAF_THROTTLE(clock, duration, SITAF_LOG_STREAM(RCUTILS_LOG_SEVERITY_DEBUG, logger, arguments))
#define RCLCPP_DEBUG_STREAM_SKIPFIRST_THROTTLE(logger, clock, duration, arguments) SITAF_SKIPFIRST(SITAF_THROTTLE(clock, duration, SITAF_LOG_STREAM(RCUTILS_LOG_SEVERITY_DEBUG, logger, arguments)))
#define RCLCPP_INFO(logger, ...) SITAF_LOG(RCUTILS_LOG_SEVERITY_INFO, logger, __VA_ARGS__)
#define RCLCPP_INFO_ONCE(logger, ...) SITAF_ONCE(SITAF_LOG(RCUTILS_LOG_SEVERITY_INFO, logger, __VA_ARGS__))
#define RCLCPP_INFO_SKIPFIRST(logger, ...) SITAF_SKIPFIRST(SITAF_LOG(RCUTILS_LOG_SEVERITY_INFO, logger, __VA_ARGS__))
#define RCLCPP_INFO_EXPRESSION(logger, expression, ...) do {if (expression) {SITAF_LOG(RCUTILS_LOG_SEVERITY_INFO, logger, __VA_ARGS__);}} while (0)
#define RCLCPP_INFO_FUNCTION(logger, function, ...) do {if ((*function)()) {SITAF_LOG(RCUTILS_LOG_SEVERITY_INFO, logger, __VA_ARGS__);}} while (0)
#define RCLCPP_INFO_THROTTLE(logger, clock, duration, ...) SITAF_THROTTLE(clock, duration, SITAF_LOG(RCUTILS_LOG_SEVERITY_INFO, logger, __VA_ARGS__))
#define RCLCPP_INFO_SKIPFIRST_THROTTLE(logger, clock, duration, ...) SITAF_SKIPFIRST(SITAF_THROTTLE(clock, duration, SITAF_LOG(RCUTILS_LOG_SEVERITY_INFO, logger, __VA_ARGS__)))
#define RCLCPP_INFO_STREAM(logger, arguments) SITAF_LOG_STREAM(RCUTILS_LOG_SEVERITY_INFO, logger, arguments)
#define RCLCPP_INFO_STREAM_ONCE(logger, arguments) SITAF_ONCE(SITAF_LOG_STREAM(RCUTILS_LOG_SEVERITY_INFO, logger, arguments))
#define RCLCPP_INFO_STREAM_SKIPFIRST(logger, arguments) SITAF_SKIPFIRST(SITAF_LOG_STREAM(RCUTILS_LOG_SEVERITY_INFO, logger, arguments))
#define RCLCPP_INFO_STREAM_EXPRESSION(logger, expression, arguments) do {if (expression) {SITAF_LOG_STREAM(RCUTILS_LOG_SEVERITY_INFO, logger, arguments);}} while (0)
#define RCLCPP_INFO_STREAM_FUNCTION(logger, function, arguments) do {if ((*function)()) {SITAF_LOG_STREAM(RCUTILS_LOG_SEVERITY_INFO, logger, arguments);}} while (0)
#define RCLCPP_INFO_STREAM_THROTTLE(logger, clock, duration, arguments) SITAF_THROTTLE(clock, duration, SITAF_LOG_STREAM(RCUTILS_LOG_SEVERITY_INFO, logger, arguments))
#define RCLCPP_INFO_STREAM_SKIPFIRST_THROTTLE(logger, clock, duration, arguments) SITAF_SKIPFIRST(SITAF_THROTTLE(clock, duration, SITAF_LOG_STREAM(RCUTILS_LOG_SEVERITY_INFO, logger, arguments)))
#define RCLCPP_WARN(logger, ...) SITAF_LOG(RCUTILS_LOG_SEVERITY_WARN, logger, __VA_ARGS__)
#define RCLCPP_WARN_ONCE(logger, ...) SITAF_ONCE(SITAF_LOG(RCUTILS_LOG_SEVERITY_WARN, logger, __VA_ARGS__))
#define RCLCPP_WARN_SKIPFIRST(logger, ...) SITAF_SKIPFIRST(SITAF_LOG(RCUTILS_LOG_SEVERITY_WARN, logger, __VA_ARGS__))
#define RCLCPP_WARN_EXPRESSION(logger, expression, ...) do {if (expression) {SITAF_LOG(RCUTILS_LOG_SEVERITY_WARN, logger, __VA_ARGS__);}} while (0)
#define RCLCPP_WARN_FUNCTION(logger, function, ...) do {if ((*function)()) {SITAF_LOG(RCUTILS_LOG_SEVERITY_WARN, logger, __VA_ARGS__);}} while (0)
#define RCLCPP_WARN_THROTTLE(logger, clock, duration, ...) SITAF_THROTTLE(clock, duration, SITAF_LOG(RCUTILS_LOG_SEVERITY_WARN, logger, __VA_ARGS__))
#define RCLCPP_WARN_SKIPFIRST_THROTTLE(logger, clock, duration, ...) SITAF_SKIPFIRST(SITAF_THROTTLE(clock, duration, SITAF_LOG(RCUTILS_LOG_SEVERITY_WARN, logger, __VA_ARGS__)))
#define RCLCPP_WARN_STREAM(logger, arguments) SITAF_LOG_STREAM(RCUTILS_LOG_SEVERITY_WARN, logger, arguments)
#define RCLCPP_WARN_STREAM_ONCE(logger, arguments) SITAF_ONCE(SITAF_LOG_STREAM(RCUTILS_LOG_SEVERITY_WARN, logger, arguments))
#define RCLCPP_WARN_STREAM_SKIPFIRST(logger, arguments) SITAF_SKIPFIRST(SITAF_LOG_STREAM(RCUTILS_LOG_SEVERITY_WARN, logger, arguments))
#define RCLCPP_WARN_STREAM_EXPRESSION(logger, expression, arguments) do {if (expression) {SITAF_LOG_STREAM(RCUTILS_LOG_SEVERITY_WARN, logger, arguments);}} while (0)
#define RCLCPP_WARN_STREAM_FUNCTION(logger, function, arguments) do {if ((*function)()) {SITAF_LOG_STREAM(RCUTILS_LOG_SEVERITY_WARN, logger, arguments);}} while (0)
#define RCLCPP_WARN_STREAM_THROTTLE(logger, clock, duration, arguments) SITAF_THROTTLE(clock, duration, SITAF_LOG_STREAM(RCUTILS_LOG_SEVERITY_WARN, logger, arguments))
#define RCLCPP_WARN_STREAM_SKIPFIRST_THROTTLE(logger, clock, duration, arguments) SITAF_SKIPFIRST(SITAF_THROTTLE(clock, duration, SITAF_LOG_STREAM(RCUTILS_LOG_SEVERITY_WARN, logger, arguments)))
#define RCLCPP_ERROR(logger, ...) SITAF_LOG(RCUTILS_LOG_SEVERITY_ERROR, logger, __VA_ARGS__)
#define RCLCPP_ERROR_ONCE(logger, ...) SITAF_ONCE(SITAF_LOG(RCUTILS_LOG_SEVERITY_ERROR, logger, __VA_ARGS__))
#define RCLCPP_ERROR_SKIPFIRST(logger, ...) SITAF_SKIPFIRST(SITAF_LOG(RCUTILS_LOG_SEVERITY_ERROR, logger, __VA_ARGS__))
#define RCLCPP_ERROR_EXPRESSION(logger, expression, ...) do {if (expression) {SITAF_LOG(RCUTILS_LOG_SEVERITY_ERROR, logger, __VA_ARGS__);}} while (0)
#define RCLCPP_ERROR_FUNCTION(logger, function, ...) do {if ((*function)()) {SITAF_LOG(RCUTILS_LOG_SEVERITY_ERROR, logger, __VA_ARGS__);}} while (0)
#define RCLCPP_ERROR_THROTTLE(logger, clock, duration, ...) SITAF_THROTTLE(clock, duration, SITAF_LOG(RCUTILS_LOG_SEVERITY_ERROR, logger, __VA_ARGS__))
#define RCLCPP_ERROR_SKIPFIRST_THROTTLE(logger, clock, duration, ...) SITAF_SKIPFIRST(SITAF_THROTTLE(clock, duration, SITAF_LOG(RCUTILS_LOG_SEVERITY_ERROR, logger, __VA_ARGS__)))
#define RCLCPP_ERROR_STREAM(logger, arguments) SITAF_LOG_STREAM(RCUTILS_LOG_SEVERITY_ERROR, logger, arguments)
#define RCLCPP_ERROR_STREAM_ONCE(logger, arguments) SITAF_ONCE(SITAF_LOG_STREAM(RCUTILS_LOG_SEVERITY_ERROR, logger, arguments))
#define RCLCPP_ERROR_STREAM_SKIPFIRST(logger, arguments) SITAF_SKIPFIRST(SITAF_LOG_STREAM(RCUTILS_LOG_SEVERITY_ERROR, logger, arguments))
#define RCLCPP_ERROR_STREAM_EXPRESSION(logger, expression, arguments) do {if (expression) {SITAF_LOG_STREAM(RCUTILS_LOG_SEVERITY_ERROR, logger, arguments);}} while (0)
#define RCLCPP_ERROR_STREAM_FUNCTION(logger, function, arguments) do {if ((*function)()) {SITAF_LOG_STREAM(RCUTILS_LOG_SEVERITY_ERROR, logger, arguments);}} while (0)
#define RCLCPP_ERROR_STREAM_THROTTLE(logger, clock, duration, arguments) SITAF_THROTTLE(clock, duration, SITAF_LOG_STREAM(RCUTILS_LOG_SEVERITY_ERROR, logger, arguments))
#define RCLCPP_ERROR_STREAM_SKIPFIRST_THROTTLE(logger, clock, duration, arguments) SITAF_SKIPFIRST(SITAF_THROTTLE(clock, duration, SITAF_LOG_STREAM(RCUTILS_LOG_SEVERITY_ERROR, logger, arguments)))
#define RCLCPP_FATAL(logger, ...) SITAF_LOG(RCUTILS_LOG_SEVERITY_FATAL, logger, __VA_ARGS__)
#define RCLCPP_FATAL_ONCE(logger, ...) SITAF_ONCE(SITAF_LOG(RCUTILS_LOG_SEVERITY_FATAL, logger, __VA_ARGS__))
#define RCLCPP_FATAL_SKIPFIRST(logger, ...) SITAF_SKIPFIRST(SITAF_LOG(RCUTILS_LOG_SEVERITY_FATAL, logger, __VA_ARGS__))
#define RCLCPP_FATAL_EXPRESSION(logger, expression, ...) do {if (expression) {SITAF_LOG(RCUTILS_LOG_SEVERITY_FATAL, logger, __VA_ARGS__);}} while (0)
#define RCLCPP_FATAL_FUNCTION(logger, function, ...) do {if ((*function)()) {SITAF_LOG(RCUTILS_LOG_SEVERITY_FATAL, logger, __VA_ARGS__);}} while (0)
#define RCLCPP_FATAL_THROTTLE(logger, clock, duration, ...) SITAF_THROTTLE(clock, duration, SITAF_LOG(RCUTILS_LOG_SEVERITY_FATAL, logger, __VA_ARGS__))
#define RCLCPP_FATAL_SKIPFIRST_THROTTLE(logger, clock, duration, ...) SITAF_SKIPFIRST(SITAF_THROTTLE(clock, duration, SITAF_LOG(RCUTILS_LOG_SEVERITY_FATAL, logger, __VA_ARGS__)))
#define RCLCPP_FATAL_STREAM(logger, arguments) SITAF_LOG_STREAM(RCUTILS_LOG_SEVERITY_FATAL, logger, arguments)
#define RCLCPP_FATAL_STREAM_ONCE(logger, arguments) SITAF_ONCE(SITAF_LOG_STREAM(RCUTILS_LOG_SEVERITY_FATAL, logger, arguments))
#define RCLCPP_FATAL_STREAM_SKIPFIRST(logger, arguments) SITAF_SKIPFIRST(SITAF_LOG_STREAM(RCUTILS_LOG_SEVERITY_FATAL, logger, arguments))
#define RCLCPP_FATAL_STREAM_EXPRESSION(logger, expression, arguments) do {if (expression) {SITAF_LOG_STREAM(RCUTILS_LOG_SEVERITY_FATAL, logger, arguments);}} while (0)
#define RCLCPP_FATAL_STREAM_FUNCTION(logger, function, arguments) do {if ((*function)()) {SITAF_LOG_STREAM(RCUTILS_LOG_SEVERITY_FATAL, logger, arguments);}} while (0)
#define RCLCPP_FATAL_STREAM_THROTTLE(logger, clock, duration, arguments) SITAF_THROTTLE(clock, duration, SITAF_LOG_STREAM(RCUTILS_LOG_SEVERITY_FATAL, logger, arguments))
#define RCLCPP_FATAL_STREAM_SKIPFIRST_THROTTLE(logger, clock, duration, arguments) SITAF_SKIPFIRST(SITAF_THROTTLE(clock, duration, SITAF_LOG_STREAM(RCUTILS_LOG_SEVERITY_FATAL, logger, arguments)))
