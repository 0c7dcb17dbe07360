// Parameters of a node, and their services.
#include <algorithm>
#include <cmath>
#include <set>

#include "case.hpp"
#include "rcl_interfaces/srv/describe_parameters.hpp"
#include "rcl_interfaces/srv/get_parameter_types.hpp"
#include "rcl_interfaces/srv/get_parameters.hpp"
#include "rcl_interfaces/srv/list_parameters.hpp"
#include "rcl_interfaces/srv/set_parameters.hpp"
#include "rcl_interfaces/srv/set_parameters_atomically.hpp"
#include "rclcpp/create.hpp"

namespace rclcpp {
namespace node_interfaces {

namespace {

SetResult refused(const std::string & reason)
{
  SetResult result;
  result.successful = false;
  result.reason = reason;
  return result;
}

bool near(double a, double b) {return std::abs(a - b) <= 1e-9 * std::max({1.0, std::abs(a), std::abs(b)});}

/// What is wrong with a value; empty if nothing is.
std::string problem(
  const std::string & name, const ParameterValue & value, const rcl_interfaces::msg::ParameterDescriptor & descriptor)
{
  const std::string range = "Parameter {" + name + "} doesn't comply with ";
  if (value.get_type() == PARAMETER_INTEGER && !descriptor.integer_range.empty()) {
    const auto & limits = descriptor.integer_range[0];
    const std::int64_t given = value.get<std::int64_t>();
    if (given != limits.from_value && given != limits.to_value &&
      (given < limits.from_value || given > limits.to_value ||
      (limits.step > 0 && (given - limits.from_value) % static_cast<std::int64_t>(limits.step) != 0)))
    {
      return range + "integer range.";
    }
  }
  if (value.get_type() == PARAMETER_DOUBLE && !descriptor.floating_point_range.empty()) {
    const auto & limits = descriptor.floating_point_range[0];
    const double given = value.get<double>();
    if (near(given, limits.from_value) || near(given, limits.to_value)) {
      return "";
    }
    const double steps = limits.step > 0 ? (given - limits.from_value) / limits.step : 0;
    if (!(given >= limits.from_value && given <= limits.to_value) || !near(steps, std::round(steps))) {
      return range + "floating point range.";
    }
  }
  return "";
}

template<class L>
void prune(L & handles)
{
  handles.remove_if([](const auto & weak) {return weak.expired();});
}

template<class H, class F, class L>
std::shared_ptr<H> add_first(L & handles, F callback)
{
  auto handle = std::make_shared<H>();
  handle->callback = std::move(callback);
  handles.push_front(handle);
  return handle;
}

template<class L, class H>
void take_out(L & handles, const H * handle)
{
  const auto found = std::find_if(
    handles.begin(), handles.end(), [&](const auto & weak) {return weak.lock().get() == handle;});
  if (found == handles.end()) {
    throw std::runtime_error("Callback doesn't exist");
  }
  handles.erase(found);
}

}  // namespace

const ParameterValue & NodeCore::declare_parameter(
  const std::string & name, const ParameterValue & value, const rcl_interfaces::msg::ParameterDescriptor & given,
  bool ignore_override)
{
  if (name.empty()) {
    throw exceptions::InvalidParametersException("parameter name must not be empty");
  }
  if (has_parameter(name)) {
    throw exceptions::ParameterAlreadyDeclaredException("parameter '" + name + "' has already been declared");
  }
  auto & used = sitaf_ros::Unobserved::get().overrides;
  const auto counted = used.find(name);
  if (counted != used.end()) {
    counted->second = true;
  }
  auto descriptor = given;
  descriptor.name = name;
  if (!descriptor.dynamic_typing) {
    if (value.get_type() == PARAMETER_NOT_SET && descriptor.type == PARAMETER_NOT_SET) {
      throw exceptions::InvalidParameterTypeException(
              name, "cannot declare a statically typed parameter with an uninitialized value");
    }
    descriptor.type = descriptor.type == PARAMETER_NOT_SET ? static_cast<std::uint8_t>(value.get_type()) : descriptor.type;
  }
  const auto overridden = overrides_.find(name);
  const bool has_override = !ignore_override && overridden != overrides_.end();
  const ParameterValue begun = has_override ? overridden->second : value;
  if (!descriptor.dynamic_typing && begun.get_type() != PARAMETER_NOT_SET && begun.get_type() != descriptor.type) {
    throw exceptions::InvalidParameterTypeException(
            name, "parameter '" + name + "' has invalid type: expected [" +
            to_string(static_cast<ParameterType>(descriptor.type)) + "] got [" + to_string(begun.get_type()) + "]");
  }
  parameters_[name] = {ParameterValue(), descriptor};
  const SetResult result = begun.get_type() == PARAMETER_NOT_SET ? change({}, true) : change({Parameter(name, begun)}, true);
  if (!result.successful) {
    parameters_.erase(name);
    throw exceptions::InvalidParameterValueException("parameter '" + name + "' could not be set: " + result.reason);
  }
  return parameters_[name].value;
}

const ParameterValue & NodeCore::declare_parameter(
  const std::string & name, ParameterType type, const rcl_interfaces::msg::ParameterDescriptor & given, bool ignore)
{
  auto descriptor = given;
  descriptor.type = static_cast<std::uint8_t>(type);
  if (descriptor.dynamic_typing) {
    throw std::invalid_argument("cannot declare parameter of specific type and pass descriptor with `dynamic_typing=true`");
  }
  return declare_parameter(name, ParameterValue(), descriptor, ignore);
}

void NodeCore::undeclare_parameter(const std::string & name)
{
  const auto found = parameters_.find(name);
  if (found == parameters_.end()) {
    throw exceptions::ParameterNotDeclaredException(
            "cannot undeclare parameter '" + name + "' which has not yet been declared");
  }
  if (found->second.descriptor.read_only) {
    throw exceptions::ParameterImmutableException("cannot undeclare parameter '" + name + "' because it is read-only");
  }
  if (!found->second.descriptor.dynamic_typing) {
    throw exceptions::InvalidParameterTypeException(name, "cannot undeclare a statically typed parameter");
  }
  parameters_.erase(found);
}

std::vector<SetResult> NodeCore::set_parameters(const std::vector<Parameter> & parameters)
{
  std::vector<SetResult> results;
  for (const Parameter & parameter : parameters) {
    results.push_back(set_parameters_atomically({parameter}));
  }
  return results;
}

SetResult NodeCore::set_parameters_atomically(const std::vector<Parameter> & parameters)
{
  return change(parameters, false);
}

SetResult NodeCore::change(std::vector<Parameter> parameters, bool declaring)
{
  if (!declaring) {
    prune(pre_set_);
    for (const auto & weak : std::list(pre_set_)) {
      if (const auto handle = weak.lock()) {
        handle->callback(parameters);
      }
    }
  }
  for (const Parameter & parameter : parameters) {
    const std::string & name = parameter.get_name();
    if (name.empty()) {
      throw exceptions::InvalidParametersException("parameter name must not be empty");
    }
    const auto found = parameters_.find(name);
    if (found == parameters_.end()) {
      if (!options.allow_undeclared_parameters()) {
        throw exceptions::ParameterNotDeclaredException(
                "parameter '" + name + "' cannot be set because it was not declared");
      }
      continue;
    }
    const auto & descriptor = found->second.descriptor;
    if (descriptor.read_only && !declaring) {
      return refused("parameter '" + name + "' cannot be set because it is read-only");
    }
    if (!descriptor.dynamic_typing && parameter.get_type() != descriptor.type && parameter.get_type() != PARAMETER_NOT_SET) {
      return refused(
        "Wrong parameter type, parameter {" + name + "} is of type {" +
        to_string(static_cast<ParameterType>(descriptor.type)) + "}, setting it to {" + to_string(parameter.get_type()) +
        "} is not allowed.");
    }
    const std::string wrong = problem(name, parameter.get_parameter_value(), descriptor);
    if (!wrong.empty()) {
      return refused(wrong);
    }
  }
  prune(on_set_);
  SetResult result;
  result.successful = true;
  if (!parameters.empty()) {
    for (const auto & weak : std::list(on_set_)) {
      if (const auto handle = weak.lock()) {
        result = handle->callback(parameters);
        if (!result.successful) {
          return result;
        }
      }
    }
  }
  rcl_interfaces::msg::ParameterEvent event;
  event.node = full_name_;
  event.stamp = clock_->now();
  for (const Parameter & parameter : parameters) {
    auto & info = parameters_[parameter.get_name()];
    const bool is_new = info.value.get_type() == PARAMETER_NOT_SET;
    info.descriptor.name = parameter.get_name();
    if (parameter.get_type() == PARAMETER_NOT_SET) {
      event.deleted_parameters.push_back(parameter.to_parameter_msg());
      parameters_.erase(parameter.get_name());
      continue;
    }
    if (info.descriptor.type == PARAMETER_NOT_SET || info.descriptor.dynamic_typing) {
      info.descriptor.type = static_cast<std::uint8_t>(parameter.get_type());
    }
    info.value = parameter.get_parameter_value();
    (is_new ? event.new_parameters : event.changed_parameters).push_back(parameter.to_parameter_msg());
  }
  prune(post_set_);
  if (!declaring) {
    for (const auto & weak : std::list(post_set_)) {
      if (const auto handle = weak.lock()) {
        handle->callback(parameters);
      }
    }
  }
  if (events_ != nullptr && !parameters.empty()) {
    events_->publish(event);
  }
  return result;
}

Parameter NodeCore::get_parameter(const std::string & name) const
{
  const auto found = parameters_.find(name);
  if (found == parameters_.end()) {
    if (options.allow_undeclared_parameters()) {
      return Parameter(name);
    }
    throw exceptions::ParameterNotDeclaredException(name);
  }
  if (found->second.value.get_type() == PARAMETER_NOT_SET && !found->second.descriptor.dynamic_typing) {
    throw exceptions::ParameterUninitializedException(name);
  }
  return Parameter(name, found->second.value);
}

bool NodeCore::get_parameter(const std::string & name, Parameter & parameter) const
{
  const auto found = parameters_.find(name);
  if (found == parameters_.end() || found->second.value.get_type() == PARAMETER_NOT_SET) {
    return false;
  }
  parameter = Parameter(name, found->second.value);
  return true;
}

std::vector<Parameter> NodeCore::get_parameters(const std::vector<std::string> & names) const
{
  std::vector<Parameter> found;
  for (const std::string & name : names) {
    found.push_back(get_parameter(name));
  }
  return found;
}

bool NodeCore::get_parameters_by_prefix(const std::string & prefix, std::map<std::string, Parameter> & found) const
{
  const std::string begin = prefix.empty() ? "" : prefix + ".";
  bool any = false;
  for (const auto & [name, info] : parameters_) {
    if (name.rfind(begin, 0) == 0 && name.size() > begin.size()) {
      found[name.substr(begin.size())] = Parameter(name, info.value);
      any = true;
    }
  }
  return any;
}

std::vector<rcl_interfaces::msg::ParameterDescriptor> NodeCore::describe_parameters(
  const std::vector<std::string> & names) const
{
  std::vector<rcl_interfaces::msg::ParameterDescriptor> found;
  for (const std::string & name : names) {
    const auto info = parameters_.find(name);
    if (info != parameters_.end()) {
      found.push_back(info->second.descriptor);
    } else if (options.allow_undeclared_parameters()) {
      found.emplace_back();
      found.back().name = name;
    } else {
      throw exceptions::ParameterNotDeclaredException(name);
    }
  }
  return found;
}

std::vector<std::uint8_t> NodeCore::get_parameter_types(const std::vector<std::string> & names) const
{
  std::vector<std::uint8_t> found;
  for (const std::string & name : names) {
    const auto info = parameters_.find(name);
    if (info == parameters_.end() && !options.allow_undeclared_parameters()) {
      throw exceptions::ParameterNotDeclaredException(name);
    }
    found.push_back(info == parameters_.end() ? 0 : static_cast<std::uint8_t>(info->second.value.get_type()));
  }
  return found;
}

rcl_interfaces::msg::ListParametersResult NodeCore::list_parameters(
  const std::vector<std::string> & prefixes, std::uint64_t depth) const
{
  rcl_interfaces::msg::ListParametersResult result;
  std::set<std::string> found;
  const auto dots = [](const std::string & text) {
      return static_cast<std::uint64_t>(std::count(text.begin(), text.end(), '.'));
    };
  for (const auto & [name, info] : parameters_) {
    (void)info;
    bool chosen = prefixes.empty() && (depth == 0 || dots(name) < depth);
    for (const std::string & prefix : prefixes) {
      const bool below = name.rfind(prefix + ".", 0) == 0;
      chosen |= name == prefix || (below && (depth == 0 || dots(name.substr(prefix.size())) < depth + 1));
    }
    if (chosen) {
      result.names.push_back(name);
      const auto last = name.rfind('.');
      if (last != std::string::npos && found.insert(name.substr(0, last)).second) {
        result.prefixes.push_back(name.substr(0, last));
      }
    }
  }
  return result;
}

OnSetParametersCallbackHandle::SharedPtr NodeCore::add_on_set_parameters_callback(OnSetParametersCallbackType callback)
{
  return add_first<OnSetParametersCallbackHandle>(on_set_, std::move(callback));
}
PreSetParametersCallbackHandle::SharedPtr NodeCore::add_pre_set_parameters_callback(
  PreSetParametersCallbackType callback)
{
  return add_first<PreSetParametersCallbackHandle>(pre_set_, std::move(callback));
}
PostSetParametersCallbackHandle::SharedPtr NodeCore::add_post_set_parameters_callback(
  PostSetParametersCallbackType callback)
{
  return add_first<PostSetParametersCallbackHandle>(post_set_, std::move(callback));
}
void NodeCore::remove_on_set_parameters_callback(const OnSetParametersCallbackHandle * handle)
{
  take_out(on_set_, handle);
}
void NodeCore::remove_pre_set_parameters_callback(const PreSetParametersCallbackHandle * handle)
{
  take_out(pre_set_, handle);
}
void NodeCore::remove_post_set_parameters_callback(const PostSetParametersCallbackHandle * handle)
{
  take_out(post_set_, handle);
}

void NodeCore::make_services()
{
  using namespace rcl_interfaces::srv;  // NOLINT
  const auto self = shared_from_this();
  const std::string base = "~/";
  // `this` outlives its services, which it holds.
  services_.push_back(create_service<GetParameters>(
      self, base + "get_parameters",
      [this](GetParameters::Request::SharedPtr request, GetParameters::Response::SharedPtr response) {
        for (const std::string & name : request->names) {
          const auto found = parameters_.find(name);
          if (found == parameters_.end()) {
            // As ROS does for parameters that are not declared.
            response->values.clear();
            return;
          }
          response->values.push_back(found->second.value.to_value_msg());
        }
      }));
  services_.push_back(create_service<GetParameterTypes>(
      self, base + "get_parameter_types",
      [this](GetParameterTypes::Request::SharedPtr request, GetParameterTypes::Response::SharedPtr response) {
        try {
          response->types = get_parameter_types(request->names);
        } catch (const exceptions::ParameterNotDeclaredException &) {
          response->types.clear();
        }
      }));
  const auto set = [this](const rcl_interfaces::msg::Parameter & message) {
      try {
        return set_parameters_atomically({Parameter::from_parameter_msg(message)});
      } catch (const exceptions::ParameterNotDeclaredException & e) {
        return refused(e.what());
      }
    };
  services_.push_back(create_service<SetParameters>(
      self, base + "set_parameters",
      [set](SetParameters::Request::SharedPtr request, SetParameters::Response::SharedPtr response) {
        for (const auto & message : request->parameters) {
          response->results.push_back(set(message));
        }
      }));
  services_.push_back(create_service<SetParametersAtomically>(
      self, base + "set_parameters_atomically",
      [this](SetParametersAtomically::Request::SharedPtr request, SetParametersAtomically::Response::SharedPtr response) {
        std::vector<Parameter> parameters;
        for (const auto & message : request->parameters) {
          parameters.push_back(Parameter::from_parameter_msg(message));
        }
        try {
          response->result = set_parameters_atomically(parameters);
        } catch (const exceptions::ParameterNotDeclaredException &) {
          response->result = refused("One or more parameters were not declared before setting");
        }
      }));
  services_.push_back(create_service<DescribeParameters>(
      self, base + "describe_parameters",
      [this](DescribeParameters::Request::SharedPtr request, DescribeParameters::Response::SharedPtr response) {
        try {
          response->descriptors = describe_parameters(request->names);
        } catch (const exceptions::ParameterNotDeclaredException &) {
          response->descriptors.clear();
        }
      }));
  services_.push_back(create_service<ListParameters>(
      self, base + "list_parameters",
      [this](ListParameters::Request::SharedPtr request, ListParameters::Response::SharedPtr response) {
        response->result = list_parameters(request->prefixes, request->depth);
      }));
}

}  // namespace node_interfaces
}  // namespace rclcpp
