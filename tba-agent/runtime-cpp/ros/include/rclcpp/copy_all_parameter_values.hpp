#pragma once

#include "rclcpp/rclcpp.hpp"

namespace rclcpp {

/// Gives a node the parameters of another one, with their descriptors.
template<class Source, class Destination>
void copy_all_parameter_values(const Source & source, const Destination & destination, bool override_existing = false)
{
  const auto from = source->get_node_parameters_interface(), to = destination->get_node_parameters_interface();
  for (const auto & name : from->list_parameters({}, 0).names) {
    const Parameter value = from->get_parameter(name);
    if (!to->has_parameter(name)) {
      to->declare_parameter(name, value.get_parameter_value(), from->describe_parameters({name}).front());
    } else if (override_existing) {
      const auto result = to->set_parameters_atomically({value});
      if (!result.successful) {
        RCLCPP_WARN(
          get_logger("copy_all_parameter_values"), "Unable to set parameter (%s): %s!", name.c_str(),
          result.reason.c_str());
      }
    }
  }
}

}  // namespace rclcpp
