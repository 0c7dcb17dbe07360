#pragma once

#include <memory>
#include <string>
#include <vector>

#include "rclcpp/context.hpp"
#include "rclcpp/parameter.hpp"
#include "rclcpp/publisher_options.hpp"
#include "rclcpp/qos.hpp"

namespace rclcpp {

class NodeOptions
{
public:
  NodeOptions() = default;

#define SITAF_OPTION(type, name, value) \
  const type & name() const {return name ## _;} \
  NodeOptions & name(const type & given) {name ## _ = given; return *this;} \

  SITAF_OPTION(Context::SharedPtr, context, )
  SITAF_OPTION(std::vector<std::string>, arguments, )
  SITAF_OPTION(bool, use_global_arguments, )
  SITAF_OPTION(bool, enable_rosout, )
  SITAF_OPTION(bool, use_intra_process_comms, )
  SITAF_OPTION(bool, enable_topic_statistics, )
  SITAF_OPTION(bool, start_parameter_services, )
  SITAF_OPTION(bool, start_parameter_event_publisher, )
  SITAF_OPTION(bool, use_clock_thread, )
  SITAF_OPTION(bool, enable_logger_service, )
  SITAF_OPTION(QoS, clock_qos, )
  SITAF_OPTION(QoS, parameter_event_qos, )
  SITAF_OPTION(QoS, rosout_qos, )
  SITAF_OPTION(PublisherOptionsBase, parameter_event_publisher_options, )
  SITAF_OPTION(bool, allow_undeclared_parameters, )
  SITAF_OPTION(bool, automatically_declare_parameters_from_overrides, )
#undef SITAF_OPTION

  std::vector<Parameter> & parameter_overrides() {return parameter_overrides_;}
  const std::vector<Parameter> & parameter_overrides() const {return parameter_overrides_;}
  NodeOptions & parameter_overrides(const std::vector<Parameter> & given)
  {
    parameter_overrides_ = given;
    return *this;
  }
  template<class T>
  NodeOptions & append_parameter_override(const std::string & name, const T & value)
  {
    parameter_overrides_.emplace_back(name, ParameterValue(value));
    return *this;
  }

private:
  Context::SharedPtr context_ = contexts::get_global_default_context();
  std::vector<std::string> arguments_;
  std::vector<Parameter> parameter_overrides_;
  bool use_global_arguments_ = true, enable_rosout_ = true, use_intra_process_comms_ = false;
  bool enable_topic_statistics_ = false, start_parameter_services_ = true, start_parameter_event_publisher_ = true;
  bool use_clock_thread_ = true, enable_logger_service_ = false, allow_undeclared_parameters_ = false;
  bool automatically_declare_parameters_from_overrides_ = false;
  QoS clock_qos_ = ClockQoS(), parameter_event_qos_ = ParameterEventsQoS(), rosout_qos_ = RosoutQoS();
  PublisherOptionsBase parameter_event_publisher_options_;
};

}  // namespace rclcpp
