#include "rclcpp/parameter_client.hpp"

namespace rclcpp {

using namespace rcl_interfaces::srv;  // NOLINT

void AsyncParametersClient::begin(Interface node, const std::string & remote, const CallbackGroup::SharedPtr & group)
{
  node_ = node;
  const std::string base = (remote.empty() ? node->get_fully_qualified_name() : remote) + std::string("/");
  const auto qos = ServicesQoS();
  get_ = create_client<GetParameters>(node, base + "get_parameters", qos, group);
  types_ = create_client<GetParameterTypes>(node, base + "get_parameter_types", qos, group);
  set_ = create_client<SetParameters>(node, base + "set_parameters", qos, group);
  atomic_ = create_client<SetParametersAtomically>(node, base + "set_parameters_atomically", qos, group);
  list_ = create_client<ListParameters>(node, base + "list_parameters", qos, group);
  describe_ = create_client<DescribeParameters>(node, base + "describe_parameters", qos, group);
}

namespace {

/// Sends a request and converts its response.
template<class T, class S, class F>
std::shared_future<T> ask(
  Client<S> & client, const typename Client<S>::SharedRequest & request, F convert,
  const std::function<void(std::shared_future<T>)> & done)
{
  auto promise = std::make_shared<std::promise<T>>();
  auto future = promise->get_future().share();
  client.async_send_request(
    request, [promise, future, convert, done](typename Client<S>::SharedFuture response) {
      promise->set_value(convert(*response.get()));
      if (done) {
        done(future);
      }
    });
  return future;
}

}  // namespace

std::shared_future<std::vector<Parameter>> AsyncParametersClient::get_parameters(
  const std::vector<std::string> & names, Done<std::vector<Parameter>> done)
{
  auto request = std::make_shared<GetParameters::Request>();
  request->names = names;
  return ask<std::vector<Parameter>>(
    *get_, request, [names](const GetParameters::Response & response) {
      std::vector<Parameter> found;
      for (std::size_t i = 0; i < response.values.size() && i < names.size(); ++i) {
        found.emplace_back(names[i], ParameterValue(response.values[i]));
      }
      return found;
    }, done);
}

std::shared_future<std::vector<rcl_interfaces::msg::ParameterDescriptor>> AsyncParametersClient::describe_parameters(
  const std::vector<std::string> & names, Done<std::vector<rcl_interfaces::msg::ParameterDescriptor>> done)
{
  auto request = std::make_shared<DescribeParameters::Request>();
  request->names = names;
  return ask<std::vector<rcl_interfaces::msg::ParameterDescriptor>>(
    *describe_, request, [](const DescribeParameters::Response & response) {return response.descriptors;}, done);
}

std::shared_future<std::vector<ParameterType>> AsyncParametersClient::get_parameter_types(
  const std::vector<std::string> & names, Done<std::vector<ParameterType>> done)
{
  auto request = std::make_shared<GetParameterTypes::Request>();
  request->names = names;
  return ask<std::vector<ParameterType>>(
    *types_, request, [](const GetParameterTypes::Response & response) {
      std::vector<ParameterType> found;
      for (const auto type : response.types) {
        found.push_back(static_cast<ParameterType>(type));
      }
      return found;
    }, done);
}

std::shared_future<std::vector<SetResult>> AsyncParametersClient::set_parameters(
  const std::vector<Parameter> & parameters, Done<std::vector<SetResult>> done)
{
  auto request = std::make_shared<SetParameters::Request>();
  for (const auto & parameter : parameters) {
    request->parameters.push_back(parameter.to_parameter_msg());
  }
  return ask<std::vector<SetResult>>(
    *set_, request, [](const SetParameters::Response & response) {return response.results;}, done);
}

std::shared_future<SetResult> AsyncParametersClient::set_parameters_atomically(
  const std::vector<Parameter> & parameters, Done<SetResult> done)
{
  auto request = std::make_shared<SetParametersAtomically::Request>();
  for (const auto & parameter : parameters) {
    request->parameters.push_back(parameter.to_parameter_msg());
  }
  return ask<SetResult>(
    *atomic_, request, [](const SetParametersAtomically::Response & response) {return response.result;}, done);
}

std::shared_future<std::vector<SetResult>> AsyncParametersClient::delete_parameters(
  const std::vector<std::string> & names)
{
  std::vector<Parameter> parameters;
  for (const auto & name : names) {
    parameters.emplace_back(name);
  }
  return set_parameters(parameters);
}

std::shared_future<rcl_interfaces::msg::ListParametersResult> AsyncParametersClient::list_parameters(
  const std::vector<std::string> & prefixes, std::uint64_t depth,
  Done<rcl_interfaces::msg::ListParametersResult> done)
{
  auto request = std::make_shared<ListParameters::Request>();
  request->prefixes = prefixes;
  request->depth = depth;
  return ask<rcl_interfaces::msg::ListParametersResult>(
    *list_, request, [](const ListParameters::Response & response) {return response.result;}, done);
}

void ParameterEventHandler::handle(State & state, const rcl_interfaces::msg::ParameterEvent & event)
{
  for (const auto & weak : std::vector(state.parameters)) {
    const auto handle = weak.lock();
    Parameter parameter;
    if (handle != nullptr && handle->callback &&
      get_parameter_from_event(event, parameter, handle->parameter_name, handle->node_name))
    {
      handle->callback(parameter);
    }
  }
  for (const auto & weak : std::vector(state.events)) {
    const auto handle = weak.lock();
    if (handle != nullptr && handle->callback) {
      handle->callback(event);
    }
  }
}

bool ParameterEventHandler::get_parameter_from_event(
  const rcl_interfaces::msg::ParameterEvent & event, Parameter & parameter, const std::string & name,
  const std::string & node)
{
  if (!node.empty() && event.node != node) {
    return false;
  }
  for (const auto * list : {&event.new_parameters, &event.changed_parameters}) {
    for (const auto & message : *list) {
      if (message.name == name) {
        parameter = Parameter::from_parameter_msg(message);
        return true;
      }
    }
  }
  return false;
}

Parameter ParameterEventHandler::get_parameter_from_event(
  const rcl_interfaces::msg::ParameterEvent & event, const std::string & name, const std::string & node)
{
  Parameter parameter;
  if (!get_parameter_from_event(event, parameter, name, node)) {
    throw std::runtime_error("Parameter '" + name + "' of node '" + node + "' is not part of parameter event");
  }
  return parameter;
}

std::vector<Parameter> ParameterEventHandler::get_parameters_from_event(
  const rcl_interfaces::msg::ParameterEvent & event)
{
  std::vector<Parameter> found;
  for (const auto * list : {&event.new_parameters, &event.changed_parameters}) {
    for (const auto & message : *list) {
      found.push_back(Parameter::from_parameter_msg(message));
    }
  }
  return found;
}

}  // namespace rclcpp
