// The methods that Node and LifecycleNode share.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "rclcpp/create.hpp"

namespace rclcpp {

enum class EndpointType {Invalid = 0, Publisher = 1, Subscription = 2};

class TopicEndpointInfo
{
public:
  TopicEndpointInfo(std::string node, std::string name_space, std::string type, QoS qos, EndpointType endpoint)
  : node_(std::move(node)), namespace_(std::move(name_space)), type_(std::move(type)), qos_(std::move(qos)),
    endpoint_(endpoint) {}
  EndpointType endpoint_type() const {return endpoint_;}
  const std::string & node_name() const {return node_;}
  const std::string & node_namespace() const {return namespace_;}
  const std::string & topic_type() const {return type_;}
  const QoS & qos_profile() const {return qos_;}

private:
  std::string node_, namespace_, type_;
  QoS qos_;
  EndpointType endpoint_;
};

class Event
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Event)
  std::uint64_t seen = sitaf_ros::Graph::get().changes;
  bool set() {return check();}
  bool check() const {return seen != sitaf_ros::Graph::get().changes;}
  bool check_and_clear()
  {
    const bool was = check();
    seen = sitaf_ros::Graph::get().changes;
    return was;
  }
};

class NodeApi
{
public:
  using OnSetParametersCallbackHandle = node_interfaces::OnSetParametersCallbackHandle;
  using OnSetParametersCallbackType = node_interfaces::OnSetParametersCallbackType;
  using PreSetParametersCallbackHandle = node_interfaces::PreSetParametersCallbackHandle;
  using PostSetParametersCallbackHandle = node_interfaces::PostSetParametersCallbackHandle;
  using Descriptor = rcl_interfaces::msg::ParameterDescriptor;

  NodeApi(const std::string & name, const std::string & name_space, const NodeOptions & options);
  NodeApi(std::shared_ptr<node_interfaces::NodeCore> core, const std::string & sub)
  : core_(std::move(core)), sub_(sub) {}
  virtual ~NodeApi();

  const char * get_name() const {return core_->get_name();}
  const char * get_namespace() const {return core_->get_namespace();}
  const char * get_fully_qualified_name() const {return core_->get_fully_qualified_name();}
  Logger get_logger() const {return core_->get_logger();}
  Clock::SharedPtr get_clock() {return core_->get_clock();}
  Clock::ConstSharedPtr get_clock() const {return std::as_const(*core_).get_clock();}
  Time now() const {return core_->now();}
  const NodeOptions & get_node_options() const {return core_->options;}
  const std::string & get_sub_namespace() const {return sub_;}
  std::string get_effective_namespace() const
  {
    const std::string base = get_namespace();
    return sub_.empty() ? base : (base == "/" ? base : base + "/") + sub_;
  }

  CallbackGroup::SharedPtr create_callback_group(CallbackGroupType type, bool automatic = true)
  {
    return core_->create_callback_group(type, automatic);
  }
  void for_each_callback_group(const std::function<void(CallbackGroup::SharedPtr)> & act)
  {
    core_->for_each_callback_group(act);
  }

  template<class T, class A = std::allocator<void>>
  std::shared_ptr<Publisher<T, A>> create_publisher(
    const std::string & topic, const QoS & qos,
    const PublisherOptionsWithAllocator<A> & options = PublisherOptionsWithAllocator<A>())
  {
    return rclcpp::create_publisher<T, A>(core_, sub(topic), qos, options);
  }
  template<class T, class F, class A = std::allocator<void>>
  std::shared_ptr<Subscription<T, A>> create_subscription(
    const std::string & topic, const QoS & qos, F && callback,
    const SubscriptionOptionsWithAllocator<A> & options = SubscriptionOptionsWithAllocator<A>(),
    std::shared_ptr<void> strategy = nullptr)
  {
    return rclcpp::create_subscription<T, F, A>(
      core_, sub(topic), qos, std::forward<F>(callback), options, strategy);
  }
  std::shared_ptr<GenericPublisher> create_generic_publisher(
    const std::string & topic, const std::string & type, const QoS & qos, const PublisherOptions & options = {})
  {
    return std::make_shared<GenericPublisher>(*core_, core_->resolve(sub(topic)), type, qos, options);
  }
  template<class F>
  std::shared_ptr<GenericSubscription> create_generic_subscription(
    const std::string & topic, const std::string & type, const QoS & qos, F callback,
    const SubscriptionOptions & options = {})
  {
    return rclcpp::create_generic_subscription(core_, sub(topic), type, qos, std::move(callback), options);
  }
  template<class R, class P, class F>
  typename WallTimer<F>::SharedPtr create_wall_timer(
    std::chrono::duration<R, P> period, F callback, CallbackGroup::SharedPtr group = nullptr, bool autostart = true)
  {
    return rclcpp::create_wall_timer(period, std::move(callback), group, core_.get(), nullptr, autostart);
  }
  template<class R, class P, class F>
  typename GenericTimer<F>::SharedPtr create_timer(
    std::chrono::duration<R, P> period, F callback, CallbackGroup::SharedPtr group = nullptr, bool autostart = true)
  {
    return rclcpp::create_timer(core_, get_clock(), Duration(period), std::move(callback), group, autostart);
  }
  template<class S>
  typename Client<S>::SharedPtr create_client(
    const std::string & name, const QoS & = ServicesQoS(), CallbackGroup::SharedPtr group = nullptr)
  {
    return rclcpp::create_client<S>(core_, sub(name), ServicesQoS(), group);
  }
  template<class S>
  typename Client<S>::SharedPtr create_client(
    const std::string & name, const rmw_qos_profile_t &, CallbackGroup::SharedPtr group = nullptr)
  {
    return rclcpp::create_client<S>(core_, sub(name), ServicesQoS(), group);
  }
  template<class S, class F>
  typename Service<S>::SharedPtr create_service(
    const std::string & name, F && callback, const QoS & = ServicesQoS(), CallbackGroup::SharedPtr group = nullptr)
  {
    return rclcpp::create_service<S>(core_, sub(name), std::forward<F>(callback), ServicesQoS(), group);
  }
  template<class S, class F>
  typename Service<S>::SharedPtr create_service(
    const std::string & name, F && callback, const rmw_qos_profile_t &, CallbackGroup::SharedPtr group = nullptr)
  {
    return rclcpp::create_service<S>(core_, sub(name), std::forward<F>(callback), ServicesQoS(), group);
  }

  const ParameterValue & declare_parameter(
    const std::string & name, const ParameterValue & value, const Descriptor & descriptor = {}, bool ignore = false)
  {
    return core_->declare_parameter(name, value, descriptor, ignore);
  }
  const ParameterValue & declare_parameter(
    const std::string & name, ParameterType type, const Descriptor & descriptor = {}, bool ignore = false)
  {
    return core_->declare_parameter(name, type, descriptor, ignore);
  }
  template<class T>
  auto declare_parameter(
    const std::string & name, const T & value, const Descriptor & descriptor = {}, bool ignore = false)
  {
    using Given = std::conditional_t<std::is_convertible_v<T, const char *>, std::string, T>;
    return get_declared<Given>(name, core_->declare_parameter(name, ParameterValue(value), descriptor, ignore));
  }
  template<class T>
  auto declare_parameter(const std::string & name, const Descriptor & descriptor = {}, bool ignore = false)
  {
    return get_declared<T>(
      name, core_->declare_parameter(name, detail::ParameterOf<T>::kind, descriptor, ignore));
  }
  template<class T>
  std::vector<T> declare_parameters(const std::string & name_space, const std::map<std::string, T> & parameters)
  {
    std::vector<T> values;
    for (const auto & [name, value] : parameters) {
      values.push_back(this->declare_parameter(name_space.empty() ? name : name_space + "." + name, value));
    }
    return values;
  }
  void undeclare_parameter(const std::string & name) {core_->undeclare_parameter(name);}
  bool has_parameter(const std::string & name) const {return core_->has_parameter(name);}
  SetResult set_parameter(const Parameter & parameter) {return core_->set_parameter(parameter);}
  std::vector<SetResult> set_parameters(const std::vector<Parameter> & parameters)
  {
    return core_->set_parameters(parameters);
  }
  SetResult set_parameters_atomically(const std::vector<Parameter> & parameters)
  {
    return core_->set_parameters_atomically(parameters);
  }
  Parameter get_parameter(const std::string & name) const {return core_->get_parameter(name);}
  bool get_parameter(const std::string & name, Parameter & parameter) const
  {
    return core_->get_parameter(name, parameter);
  }
  template<class T>
  bool get_parameter(const std::string & name, T & value) const
  {
    Parameter parameter;
    const bool found = core_->get_parameter(name, parameter);
    if (found) {
      value = static_cast<T>(parameter.template get_value<T>());
    }
    return found;
  }
  template<class T>
  bool get_parameter_or(const std::string & name, T & value, const T & alternative) const
  {
    const bool found = get_parameter(name, value);
    if (!found) {
      value = alternative;
    }
    return found;
  }
  template<class T>
  T get_parameter_or(const std::string & name, const T & alternative) const
  {
    T value;
    get_parameter_or(name, value, alternative);
    return value;
  }
  std::vector<Parameter> get_parameters(const std::vector<std::string> & names) const
  {
    return core_->get_parameters(names);
  }
  template<class T>
  bool get_parameters(const std::string & prefix, std::map<std::string, T> & values) const
  {
    std::map<std::string, Parameter> found;
    const bool any = core_->get_parameters_by_prefix(prefix, found);
    for (const auto & [name, parameter] : found) {
      if constexpr (std::is_same_v<T, Parameter>) {
        values[name] = parameter;
      } else {
        values[name] = static_cast<T>(parameter.template get_value<T>());
      }
    }
    return any;
  }
  Descriptor describe_parameter(const std::string & name) const {return core_->describe_parameters({name}).front();}
  std::vector<Descriptor> describe_parameters(const std::vector<std::string> & names) const
  {
    return core_->describe_parameters(names);
  }
  std::vector<std::uint8_t> get_parameter_types(const std::vector<std::string> & names) const
  {
    return core_->get_parameter_types(names);
  }
  rcl_interfaces::msg::ListParametersResult list_parameters(
    const std::vector<std::string> & prefixes, std::uint64_t depth) const
  {
    return core_->list_parameters(prefixes, depth);
  }
  [[nodiscard]] auto add_on_set_parameters_callback(OnSetParametersCallbackType callback)
  {
    return core_->add_on_set_parameters_callback(std::move(callback));
  }
  [[nodiscard]] auto add_pre_set_parameters_callback(node_interfaces::PreSetParametersCallbackType callback)
  {
    return core_->add_pre_set_parameters_callback(std::move(callback));
  }
  [[nodiscard]] auto add_post_set_parameters_callback(node_interfaces::PostSetParametersCallbackType callback)
  {
    return core_->add_post_set_parameters_callback(std::move(callback));
  }
  void remove_on_set_parameters_callback(const OnSetParametersCallbackHandle * handle)
  {
    core_->remove_on_set_parameters_callback(handle);
  }
  void remove_pre_set_parameters_callback(const PreSetParametersCallbackHandle * handle)
  {
    core_->remove_pre_set_parameters_callback(handle);
  }
  void remove_post_set_parameters_callback(const PostSetParametersCallbackHandle * handle)
  {
    core_->remove_post_set_parameters_callback(handle);
  }

  std::vector<std::string> get_node_names() const {return core_->get_node_names();}
  auto get_topic_names_and_types() const {return core_->get_topic_names_and_types();}
  auto get_service_names_and_types() const {return core_->get_service_names_and_types();}
  auto get_service_names_and_types_by_node(const std::string & node, const std::string & name_space) const
  {
    return core_->get_service_names_and_types_by_node(node, name_space);
  }
  std::size_t count_publishers(const std::string & topic) const {return core_->count_publishers(topic);}
  std::size_t count_subscribers(const std::string & topic) const {return core_->count_subscribers(topic);}
  std::size_t count_services(const std::string & name) const {return core_->count_services(name);}
  std::size_t count_clients(const std::string & name) const {return core_->count_clients(name);}
  std::vector<TopicEndpointInfo> get_publishers_info_by_topic(const std::string & topic, bool = false) const;
  std::vector<TopicEndpointInfo> get_subscriptions_info_by_topic(const std::string & topic, bool = false) const;
  Event::SharedPtr get_graph_event() {return std::make_shared<Event>();}
  void wait_for_graph_change(Event::SharedPtr event, std::chrono::nanoseconds time)
  {
    core_->wait_for_change(event->seen, time);
  }

#define SITAF_INTERFACE(name) \
  node_interfaces::NodeCore::SharedPtr get_node_ ## name ## _interface() const {return core_;}
  SITAF_INTERFACE(base)
  SITAF_INTERFACE(clock)
  SITAF_INTERFACE(graph)
  SITAF_INTERFACE(logging)
  SITAF_INTERFACE(parameters)
  SITAF_INTERFACE(services)
  SITAF_INTERFACE(time_source)
  SITAF_INTERFACE(timers)
  SITAF_INTERFACE(topics)
  SITAF_INTERFACE(type_descriptions)
  SITAF_INTERFACE(waitables)
#undef SITAF_INTERFACE

protected:
  std::shared_ptr<node_interfaces::NodeCore> core_;

private:
  template<class T>
  auto get_declared(const std::string & name, const ParameterValue & value) const
  {
    try {
      return static_cast<T>(value.template get<T>());
    } catch (const ParameterTypeException & e) {
      throw exceptions::InvalidParameterTypeException(name, e.what());
    }
  }
  std::string sub(const std::string & name) const
  {
    return sub_.empty() || name.empty() || name.front() == '/' || name.front() == '~' ? name : sub_ + "/" + name;
  }

  std::string sub_;
};

}  // namespace rclcpp
