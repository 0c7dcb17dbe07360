#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "rcl_interfaces/srv/describe_parameters.hpp"
#include "rcl_interfaces/srv/get_parameter_types.hpp"
#include "rcl_interfaces/srv/get_parameters.hpp"
#include "rcl_interfaces/srv/list_parameters.hpp"
#include "rcl_interfaces/srv/set_parameters.hpp"
#include "rcl_interfaces/srv/set_parameters_atomically.hpp"
#include "rclcpp/executor.hpp"

namespace rclcpp {

class AsyncParametersClient
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(AsyncParametersClient)
  using Interface = node_interfaces::NodeCore::SharedPtr;

  template<class N>
  explicit AsyncParametersClient(
    N && node, const std::string & remote = "", const QoS & = ParametersQoS(), CallbackGroup::SharedPtr group = nullptr)
  {
    begin(detail::core(std::forward<N>(node)), remote, group);
  }
  AsyncParametersClient(
    Interface base, Interface, Interface, Interface, const std::string & remote = "", const QoS & = ParametersQoS(),
    CallbackGroup::SharedPtr group = nullptr)
  {
    begin(base, remote, group);
  }

  template<class T>
  using Done = std::function<void (std::shared_future<T>)>;

  std::shared_future<std::vector<Parameter>> get_parameters(
    const std::vector<std::string> & names, Done<std::vector<Parameter>> done = nullptr);
  std::shared_future<std::vector<rcl_interfaces::msg::ParameterDescriptor>> describe_parameters(
    const std::vector<std::string> & names,
    Done<std::vector<rcl_interfaces::msg::ParameterDescriptor>> done = nullptr);
  std::shared_future<std::vector<ParameterType>> get_parameter_types(
    const std::vector<std::string> & names, Done<std::vector<ParameterType>> done = nullptr);
  std::shared_future<std::vector<SetResult>> set_parameters(
    const std::vector<Parameter> & parameters, Done<std::vector<SetResult>> done = nullptr);
  std::shared_future<SetResult> set_parameters_atomically(
    const std::vector<Parameter> & parameters, Done<SetResult> done = nullptr);
  std::shared_future<std::vector<SetResult>> delete_parameters(const std::vector<std::string> & names);
  std::shared_future<rcl_interfaces::msg::ListParametersResult> list_parameters(
    const std::vector<std::string> & prefixes, std::uint64_t depth,
    Done<rcl_interfaces::msg::ListParametersResult> done = nullptr);

  template<class F>
  std::shared_ptr<Subscription<rcl_interfaces::msg::ParameterEvent>> on_parameter_event(
    F && callback, const QoS & qos = ParameterEventsQoS())
  {
    return on_parameter_event(node_, std::forward<F>(callback), qos);
  }
  template<class F, class N>
  static std::shared_ptr<Subscription<rcl_interfaces::msg::ParameterEvent>> on_parameter_event(
    N && node, F && callback, const QoS & qos = ParameterEventsQoS())
  {
    return create_subscription<rcl_interfaces::msg::ParameterEvent>(
      std::forward<N>(node), "/parameter_events", qos, std::forward<F>(callback));
  }
  bool service_is_ready() const {return get_->service_is_ready() && list_->service_is_ready();}
  template<class R = std::int64_t, class P = std::milli>
  bool wait_for_service(std::chrono::duration<R, P> time = std::chrono::duration<R, P>(-1))
  {
    return list_->wait_for_service(time);
  }

private:
  void begin(Interface node, const std::string & remote, const CallbackGroup::SharedPtr & group);

  Interface node_;
  Client<rcl_interfaces::srv::GetParameters>::SharedPtr get_;
  Client<rcl_interfaces::srv::GetParameterTypes>::SharedPtr types_;
  Client<rcl_interfaces::srv::SetParameters>::SharedPtr set_;
  Client<rcl_interfaces::srv::SetParametersAtomically>::SharedPtr atomic_;
  Client<rcl_interfaces::srv::ListParameters>::SharedPtr list_;
  Client<rcl_interfaces::srv::DescribeParameters>::SharedPtr describe_;
};

class SyncParametersClient
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(SyncParametersClient)

  template<class N>
  explicit SyncParametersClient(N && node, const std::string & remote = "", const QoS & qos = ParametersQoS())
  : SyncParametersClient(std::make_shared<executors::SingleThreadedExecutor>(), std::forward<N>(node), remote, qos) {}
  template<class N>
  SyncParametersClient(
    Executor::SharedPtr executor, N && node, const std::string & remote = "", const QoS & qos = ParametersQoS())
  : node_(detail::core(node)), executor_(std::move(executor)), async_(node_, remote, qos) {}

  std::vector<Parameter> get_parameters(
    const std::vector<std::string> & names, std::chrono::nanoseconds time = std::chrono::nanoseconds(-1))
  {
    return wait(async_.get_parameters(names), time);
  }
  bool has_parameter(const std::string & name)
  {
    const auto found = list_parameters({name}, 1).names;
    return std::find(found.begin(), found.end(), name) != found.end();
  }
  template<class T>
  T get_parameter(const std::string & name)
  {
    const auto found = get_parameters({name});
    if (found.empty() || found[0].get_type() == PARAMETER_NOT_SET) {
      throw std::runtime_error("Parameter '" + name + "' is not set");
    }
    return static_cast<T>(found[0].template get_value<T>());
  }
  template<class T>
  T get_parameter(const std::string & name, const T & alternative)
  {
    const auto found = get_parameters({name});
    return found.empty() || found[0].get_type() == PARAMETER_NOT_SET ? alternative :
           static_cast<T>(found[0].template get_value<T>());
  }
  std::vector<rcl_interfaces::msg::ParameterDescriptor> describe_parameters(
    const std::vector<std::string> & names, std::chrono::nanoseconds time = std::chrono::nanoseconds(-1))
  {
    return wait(async_.describe_parameters(names), time);
  }
  std::vector<ParameterType> get_parameter_types(
    const std::vector<std::string> & names, std::chrono::nanoseconds time = std::chrono::nanoseconds(-1))
  {
    return wait(async_.get_parameter_types(names), time);
  }
  std::vector<SetResult> set_parameters(
    const std::vector<Parameter> & parameters, std::chrono::nanoseconds time = std::chrono::nanoseconds(-1))
  {
    return wait(async_.set_parameters(parameters), time);
  }
  SetResult set_parameters_atomically(
    const std::vector<Parameter> & parameters, std::chrono::nanoseconds time = std::chrono::nanoseconds(-1))
  {
    return wait(async_.set_parameters_atomically(parameters), time);
  }
  rcl_interfaces::msg::ListParametersResult list_parameters(
    const std::vector<std::string> & prefixes, std::uint64_t depth,
    std::chrono::nanoseconds time = std::chrono::nanoseconds(-1))
  {
    return wait(async_.list_parameters(prefixes, depth), time);
  }
  template<class F>
  auto on_parameter_event(F && callback) {return async_.on_parameter_event(std::forward<F>(callback));}
  template<class N, class F>
  static auto on_parameter_event(N && node, F && callback)
  {
    return AsyncParametersClient::on_parameter_event(std::forward<N>(node), std::forward<F>(callback));
  }
  bool service_is_ready() const {return async_.service_is_ready();}
  template<class R = std::int64_t, class P = std::milli>
  bool wait_for_service(std::chrono::duration<R, P> time = std::chrono::duration<R, P>(-1))
  {
    return async_.wait_for_service(time);
  }

private:
  template<class T>
  T wait(std::shared_future<T> future, std::chrono::nanoseconds time)
  {
    const auto code = executors::spin_node_until_future_complete(*executor_, node_, future, time);
    return code == FutureReturnCode::SUCCESS ? future.get() : T();
  }

  node_interfaces::NodeCore::SharedPtr node_;
  Executor::SharedPtr executor_;
  AsyncParametersClient async_;
};

struct ParameterCallbackHandle
{
  RCLCPP_SMART_PTR_DEFINITIONS(ParameterCallbackHandle)
  using ParameterCallbackType = std::function<void (const Parameter &)>;
  std::string parameter_name, node_name;
  ParameterCallbackType callback;
};

struct ParameterEventCallbackHandle
{
  RCLCPP_SMART_PTR_DEFINITIONS(ParameterEventCallbackHandle)
  using ParameterEventCallbackType = std::function<void (const rcl_interfaces::msg::ParameterEvent &)>;
  ParameterEventCallbackType callback;
};

class ParameterEventHandler
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(ParameterEventHandler)

  template<class N>
  explicit ParameterEventHandler(N && node, const QoS & qos = ParameterEventsQoS())
  : state_(std::make_shared<State>())
  {
    const auto core = detail::core(std::forward<N>(node));
    node_name_ = core->get_fully_qualified_name();
    core_ = core.get();
    auto state = state_;
    subscription_ = create_subscription<rcl_interfaces::msg::ParameterEvent>(
      core, "/parameter_events", qos,
      [state](const rcl_interfaces::msg::ParameterEvent & event) {handle(*state, event);});
  }
  ParameterEventCallbackHandle::SharedPtr add_parameter_event_callback(
    ParameterEventCallbackHandle::ParameterEventCallbackType callback)
  {
    auto handle = std::make_shared<ParameterEventCallbackHandle>();
    handle->callback = std::move(callback);
    state_->events.push_back(handle);
    return handle;
  }
  void remove_parameter_event_callback(ParameterEventCallbackHandle::SharedPtr handle) {handle->callback = nullptr;}
  ParameterCallbackHandle::SharedPtr add_parameter_callback(
    const std::string & name, ParameterCallbackHandle::ParameterCallbackType callback, const std::string & node = "")
  {
    auto handle = std::make_shared<ParameterCallbackHandle>();
    handle->parameter_name = name;
    handle->node_name = node.empty() ? node_name_ : core_->resolve_topic_name(node, true);
    handle->callback = std::move(callback);
    state_->parameters.push_back(handle);
    return handle;
  }
  void remove_parameter_callback(ParameterCallbackHandle::SharedPtr handle) {handle->callback = nullptr;}
  static bool get_parameter_from_event(
    const rcl_interfaces::msg::ParameterEvent & event, Parameter & parameter, const std::string & name,
    const std::string & node = "");
  static Parameter get_parameter_from_event(
    const rcl_interfaces::msg::ParameterEvent & event, const std::string & name, const std::string & node = "");
  static std::vector<Parameter> get_parameters_from_event(const rcl_interfaces::msg::ParameterEvent & event);

private:
  struct State
  {
    std::vector<std::weak_ptr<ParameterEventCallbackHandle>> events;
    std::vector<std::weak_ptr<ParameterCallbackHandle>> parameters;
  };
  static void handle(State & state, const rcl_interfaces::msg::ParameterEvent & event);

  std::shared_ptr<State> state_;
  std::string node_name_;
  node_interfaces::NodeCore * core_ = nullptr;
  std::shared_ptr<SubscriptionBase> subscription_;
};

}  // namespace rclcpp
