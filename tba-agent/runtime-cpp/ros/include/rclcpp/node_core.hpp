// What Node and LifecycleNode have in common: names, groups, the clock and parameters.
#pragma once

#include <atomic>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "rcl_interfaces/msg/list_parameters_result.hpp"
#include "rcl_interfaces/msg/parameter_event.hpp"
#include "rcl_interfaces/msg/set_parameters_result.hpp"
#include "rclcpp/callback_group.hpp"
#include "rclcpp/clock.hpp"
#include "rclcpp/logger.hpp"
#include "rclcpp/node_options.hpp"

namespace rclcpp {

class PublisherBase;
class SubscriptionBase;
class TimerBase;
class ClientBase;
class ServiceBase;
template<class M, class A>
class Publisher;

using SetResult = rcl_interfaces::msg::SetParametersResult;

namespace node_interfaces {

using OnSetParametersCallbackType = std::function<SetResult(const std::vector<Parameter> &)>;
using PreSetParametersCallbackType = std::function<void(std::vector<Parameter> &)>;
using PostSetParametersCallbackType = std::function<void(const std::vector<Parameter> &)>;

struct OnSetParametersCallbackHandle
{
  RCLCPP_SMART_PTR_DEFINITIONS(OnSetParametersCallbackHandle)
  using OnSetParametersCallbackType = std::function<SetResult(const std::vector<Parameter> &)>;
  using OnParametersSetCallbackType = OnSetParametersCallbackType;
  OnSetParametersCallbackType callback;
};
struct PreSetParametersCallbackHandle
{
  RCLCPP_SMART_PTR_DEFINITIONS(PreSetParametersCallbackHandle)
  using PreSetParametersCallbackType = std::function<void(std::vector<Parameter> &)>;
  PreSetParametersCallbackType callback;
};
struct PostSetParametersCallbackHandle
{
  RCLCPP_SMART_PTR_DEFINITIONS(PostSetParametersCallbackHandle)
  using PostSetParametersCallbackType = std::function<void(const std::vector<Parameter> &)>;
  PostSetParametersCallbackType callback;
};

struct ParameterInfo
{
  ParameterValue value;
  rcl_interfaces::msg::ParameterDescriptor descriptor;
};

/// Also what the interfaces of nodes are: each gives the same object.
class NodeCore : public std::enable_shared_from_this<NodeCore>
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(NodeCore)

  NodeCore(const std::string & name, const std::string & name_space, const NodeOptions & options);
  ~NodeCore();
  void begin();

  // Base.
  const char * get_name() const {return name_.c_str();}
  const char * get_namespace() const {return namespace_.c_str();}
  const char * get_fully_qualified_name() const {return full_name_.c_str();}
  Context::SharedPtr get_context() {return options.context();}
  CallbackGroup::SharedPtr create_callback_group(CallbackGroupType type, bool automatic = true);
  CallbackGroup::SharedPtr get_default_callback_group() {return groups_.front();}
  bool callback_group_in_node(const CallbackGroup::SharedPtr & group);
  void for_each_callback_group(const std::function<void(CallbackGroup::SharedPtr)> & act);
  std::shared_ptr<NodeCore> get_shared_ptr() {return shared_from_this();}
  bool get_use_intra_process_default() const {return options.use_intra_process_comms();}
  NodeCore::SharedPtr get_node_base_interface() {return shared_from_this();}
  /// The full name of a topic or service, remapped.
  std::string resolve(const std::string & name) const;
  std::string resolve_topic_name(const std::string & name, bool only_expand = false) const;
  std::string resolve_service_name(const std::string & name, bool only_expand = false) const
  {
    return resolve_topic_name(name, only_expand);
  }
  const char * get_logger_name() const {return logger_name_.c_str();}
  Logger get_logger() const {return Logger(logger_name_);}
  Clock::SharedPtr get_clock() {return clock_;}
  Clock::ConstSharedPtr get_clock() const {return clock_;}
  Time now() const {return clock_->now();}
  /// Adds something that an executor runs.
  void add(const std::shared_ptr<sitaf_ros::Entity> & entity, const CallbackGroup::SharedPtr & group);
  void add_timer(const std::shared_ptr<TimerBase> & timer, const CallbackGroup::SharedPtr & group);
  template<class W>
  void add_waitable(const std::shared_ptr<W> & waitable, const CallbackGroup::SharedPtr & group)
  {
    add(std::static_pointer_cast<sitaf_ros::Entity>(waitable), group);
  }
  template<class W>
  void remove_waitable(const std::shared_ptr<W> &, const CallbackGroup::SharedPtr &) {}

  // Graph.
  std::map<std::string, std::vector<std::string>> get_topic_names_and_types(bool = false) const;
  std::map<std::string, std::vector<std::string>> get_service_names_and_types() const;
  std::map<std::string, std::vector<std::string>> get_service_names_and_types_by_node(
    const std::string & node, const std::string & name_space) const;
  std::map<std::string, std::vector<std::string>> get_client_names_and_types_by_node(
    const std::string & node, const std::string & name_space) const;
  std::map<std::string, std::vector<std::string>> get_publisher_names_and_types_by_node(
    const std::string & node, const std::string & name_space, bool no_demangle = false) const;
  std::map<std::string, std::vector<std::string>> get_subscriber_names_and_types_by_node(
    const std::string & node, const std::string & name_space, bool no_demangle = false) const;
  std::vector<std::string> get_node_names() const;
  std::vector<std::pair<std::string, std::string>> get_node_names_and_namespaces() const;
  std::size_t count_publishers(const std::string & topic) const;
  std::size_t count_subscribers(const std::string & topic) const;
  std::size_t count_services(const std::string & name) const;
  std::size_t count_clients(const std::string & name) const;
  bool wait_for_change(std::uint64_t & seen, std::chrono::nanoseconds time);

  // Parameters.
  const ParameterValue & declare_parameter(
    const std::string & name, const ParameterValue & value,
    const rcl_interfaces::msg::ParameterDescriptor & descriptor = {}, bool ignore_override = false);
  const ParameterValue & declare_parameter(
    const std::string & name, ParameterType type, const rcl_interfaces::msg::ParameterDescriptor & descriptor = {},
    bool ignore_override = false);
  void undeclare_parameter(const std::string & name);
  bool has_parameter(const std::string & name) const {return parameters_.count(name) > 0;}
  SetResult set_parameter(const Parameter & parameter) {return set_parameters_atomically({parameter});}
  std::vector<SetResult> set_parameters(const std::vector<Parameter> & parameters);
  SetResult set_parameters_atomically(const std::vector<Parameter> & parameters);
  Parameter get_parameter(const std::string & name) const;
  bool get_parameter(const std::string & name, Parameter & parameter) const;
  std::vector<Parameter> get_parameters(const std::vector<std::string> & names) const;
  bool get_parameters_by_prefix(const std::string & prefix, std::map<std::string, Parameter> & found) const;
  std::vector<rcl_interfaces::msg::ParameterDescriptor> describe_parameters(
    const std::vector<std::string> & names) const;
  std::vector<std::uint8_t> get_parameter_types(const std::vector<std::string> & names) const;
  rcl_interfaces::msg::ListParametersResult list_parameters(
    const std::vector<std::string> & prefixes, std::uint64_t depth) const;
  OnSetParametersCallbackHandle::SharedPtr add_on_set_parameters_callback(OnSetParametersCallbackType callback);
  PreSetParametersCallbackHandle::SharedPtr add_pre_set_parameters_callback(PreSetParametersCallbackType callback);
  PostSetParametersCallbackHandle::SharedPtr add_post_set_parameters_callback(PostSetParametersCallbackType callback);
  void remove_on_set_parameters_callback(const OnSetParametersCallbackHandle * handle);
  void remove_pre_set_parameters_callback(const PreSetParametersCallbackHandle * handle);
  void remove_post_set_parameters_callback(const PostSetParametersCallbackHandle * handle);
  const std::map<std::string, ParameterValue> & get_parameter_overrides() const {return overrides_;}

  NodeOptions options;
  /// The executor that runs the node.
  bool has_executor = false;
  std::atomic_bool associated{false};
  std::atomic_bool & get_associated_with_executor_atomic() {return associated;}

private:
  SetResult change(std::vector<Parameter> parameters, bool declaring);
  void make_services();

  std::string name_, namespace_, full_name_, logger_name_;
  Clock::SharedPtr clock_;
  std::vector<CallbackGroup::SharedPtr> groups_;
  std::map<std::string, ParameterInfo> parameters_;
  std::map<std::string, ParameterValue> overrides_;
  std::list<std::weak_ptr<OnSetParametersCallbackHandle>> on_set_;
  std::list<std::weak_ptr<PreSetParametersCallbackHandle>> pre_set_;
  std::list<std::weak_ptr<PostSetParametersCallbackHandle>> post_set_;
  std::shared_ptr<Publisher<rcl_interfaces::msg::ParameterEvent, std::allocator<void>>> events_;
  std::vector<std::shared_ptr<void>> services_;
  bool declaring_ = false;
};

using NodeBaseInterface = NodeCore;
using NodeClockInterface = NodeCore;
using NodeGraphInterface = NodeCore;
using NodeLoggingInterface = NodeCore;
using NodeParametersInterface = NodeCore;
using NodeServicesInterface = NodeCore;
using NodeTimeSourceInterface = NodeCore;
using NodeTimersInterface = NodeCore;
using NodeTopicsInterface = NodeCore;
using NodeTypeDescriptionsInterface = NodeCore;
using NodeWaitablesInterface = NodeCore;

/// Some interfaces of a node; all of them are there.
template<class ... I>
class NodeInterfaces
{
public:
  NodeInterfaces() = default;
  template<class NodeT, class = decltype(std::declval<NodeT &>().get_node_base_interface())>
  NodeInterfaces(NodeT & node)
  : core_(node.get_node_base_interface()) {}
  template<class NodeT, class = decltype(std::declval<NodeT &>().get_node_base_interface())>
  NodeInterfaces(const std::shared_ptr<NodeT> & node)
  : core_(node->get_node_base_interface()) {}
  NodeInterfaces(const NodeCore::SharedPtr & core)
  : core_(core) {}
  template<class T>
  NodeCore::SharedPtr get() const {return core_;}
#define SITAF_INTERFACE(name) NodeCore::SharedPtr get_node_ ## name ## _interface() const {return core_;}
  SITAF_INTERFACE(base)
  SITAF_INTERFACE(clock)
  SITAF_INTERFACE(graph)
  SITAF_INTERFACE(logging)
  SITAF_INTERFACE(parameters)
  SITAF_INTERFACE(services)
  SITAF_INTERFACE(time_source)
  SITAF_INTERFACE(timers)
  SITAF_INTERFACE(topics)
  SITAF_INTERFACE(waitables)
#undef SITAF_INTERFACE

private:
  NodeCore::SharedPtr core_;
};

inline NodeCore::SharedPtr core_of(const NodeCore::SharedPtr & core) {return core;}
inline NodeCore::SharedPtr core_of(NodeCore * core) {return core->shared_from_this();}
/// The core of a node, of a pointer to one, or of its interfaces.
template<class T>
auto core_of(T && node) -> decltype(NodeCore::SharedPtr(node->get_node_base_interface()))
{
  return node->get_node_base_interface();
}
template<class T>
auto core_of(T && node) -> decltype(NodeCore::SharedPtr(node.get_node_base_interface()))
{
  return node.get_node_base_interface();
}

}  // namespace node_interfaces
}  // namespace rclcpp
