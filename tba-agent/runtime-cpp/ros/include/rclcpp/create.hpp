// Functions that make the parts of a node.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "rclcpp/service.hpp"
#include "rclcpp/subscription.hpp"
#include "rclcpp/timer.hpp"

namespace rclcpp {

namespace detail {

template<class N>
auto core(N && node) {return node_interfaces::core_of(std::forward<N>(node));}

}  // namespace detail

template<class T, class A = std::allocator<void>, class P = Publisher<T, A>, class N>
std::shared_ptr<P> create_publisher(
  N && node, const std::string & topic, const QoS & qos,
  const PublisherOptionsWithAllocator<A> & options = PublisherOptionsWithAllocator<A>())
{
  const auto core = detail::core(std::forward<N>(node));
  return std::make_shared<P>(*core, core->resolve(topic), qos, options);
}

template<class T, class F, class A = std::allocator<void>, class N>
std::shared_ptr<Subscription<T, A>> create_subscription(
  N && node, const std::string & topic, const QoS & qos, F && callback,
  const SubscriptionOptionsWithAllocator<A> & options = SubscriptionOptionsWithAllocator<A>(),
  std::shared_ptr<void> = nullptr)
{
  using Ros = typename sitaf_ros::Adapted<T>::Ros;
  const auto core = detail::core(std::forward<N>(node));
  auto made = std::make_shared<Subscription<T, A>>(
    *core, core->resolve(topic), Ros::sitaf_name, qos, options,
    sitaf_ros::taker<T>(std::decay_t<F>(std::forward<F>(callback))));
  core->add(made, options.callback_group);
  return made;
}

template<class F, class N>
std::shared_ptr<GenericSubscription> create_generic_subscription(
  N && node, const std::string & topic, const std::string & type, const QoS & qos, F callback,
  const SubscriptionOptions & options = {})
{
  const auto core = detail::core(std::forward<N>(node));
  auto take = [callback = std::move(callback)](sitaf_ros::Packet & packet, const MessageInfo & info) mutable {
      auto message = std::make_shared<SerializedMessage>(packet.serialized());
      if constexpr (std::is_invocable_v<F &, std::shared_ptr<SerializedMessage>>) {
        callback(message);
      } else if constexpr (std::is_invocable_v<F &, const SerializedMessage &>) {
        callback(*message);
      } else {
        callback(message, info);
      }
      (void)info;
    };
  auto made = std::make_shared<GenericSubscription>(*core, core->resolve(topic), type, qos, options, take);
  core->add(made, options.callback_group);
  return made;
}

template<class N>
std::shared_ptr<GenericPublisher> create_generic_publisher(
  N && node, const std::string & topic, const std::string & type, const QoS & qos, const PublisherOptions & options = {})
{
  const auto core = detail::core(std::forward<N>(node));
  return std::make_shared<GenericPublisher>(*core, core->resolve(topic), type, qos, options);
}

template<class R, class P, class F, class N>
typename WallTimer<F>::SharedPtr create_wall_timer(
  std::chrono::duration<R, P> period, F callback, CallbackGroup::SharedPtr group, N && node,
  node_interfaces::NodeCore * = nullptr, bool autostart = true)
{
  auto timer = std::make_shared<WallTimer<F>>(
    std::chrono::duration_cast<std::chrono::nanoseconds>(period), std::move(callback), nullptr, autostart);
  detail::core(std::forward<N>(node))->add_timer(timer, group);
  return timer;
}

template<class F, class N>
typename GenericTimer<F>::SharedPtr create_timer(
  N && node, Clock::SharedPtr clock, Duration period, F && callback, CallbackGroup::SharedPtr group = nullptr,
  bool autostart = true)
{
  auto timer = std::make_shared<GenericTimer<F>>(
    clock, std::chrono::nanoseconds(period.nanoseconds()), std::forward<F>(callback), nullptr, autostart);
  detail::core(std::forward<N>(node))->add_timer(timer, group);
  return timer;
}

template<class R, class P, class F, class N>
typename GenericTimer<F>::SharedPtr create_timer(
  N && node, Clock::SharedPtr clock, std::chrono::duration<R, P> period, F && callback,
  CallbackGroup::SharedPtr group = nullptr, bool autostart = true)
{
  return create_timer(
    std::forward<N>(node), std::move(clock), Duration(period), std::forward<F>(callback), group, autostart);
}
// With the interfaces of a node, which are one object here.
template<class F>
typename GenericTimer<F>::SharedPtr create_timer(
  node_interfaces::NodeCore::SharedPtr node, node_interfaces::NodeCore::SharedPtr, Clock::SharedPtr clock,
  Duration period, F && callback, CallbackGroup::SharedPtr group = nullptr, bool autostart = true)
{
  return create_timer(node, std::move(clock), period, std::forward<F>(callback), group, autostart);
}
template<class R, class P, class F>
typename GenericTimer<F>::SharedPtr create_timer(
  Clock::SharedPtr clock, std::chrono::duration<R, P> period, F callback, CallbackGroup::SharedPtr group,
  node_interfaces::NodeCore * node, node_interfaces::NodeCore *, bool autostart = true)
{
  return create_timer(node, std::move(clock), Duration(period), std::move(callback), group, autostart);
}
template<class T, class F, class A = std::allocator<void>>
std::shared_ptr<Subscription<T, A>> create_subscription(
  const node_interfaces::NodeCore::SharedPtr & node, const node_interfaces::NodeCore::SharedPtr &,
  const std::string & topic, const QoS & qos, F && callback,
  const SubscriptionOptionsWithAllocator<A> & options = SubscriptionOptionsWithAllocator<A>(),
  std::shared_ptr<void> = nullptr)
{
  return create_subscription<T, F, A>(node, topic, qos, std::forward<F>(callback), options);
}
template<class T, class A = std::allocator<void>, class P = Publisher<T, A>>
std::shared_ptr<P> create_publisher(
  const node_interfaces::NodeCore::SharedPtr & node, const node_interfaces::NodeCore::SharedPtr &,
  const std::string & topic, const QoS & qos,
  const PublisherOptionsWithAllocator<A> & options = PublisherOptionsWithAllocator<A>())
{
  return create_publisher<T, A, P>(node, topic, qos, options);
}

template<class S, class N>
typename Client<S>::SharedPtr create_client(
  N && node, const std::string & name, const QoS & = ServicesQoS(), CallbackGroup::SharedPtr group = nullptr)
{
  const auto core = detail::core(std::forward<N>(node));
  auto made = std::make_shared<Client<S>>(*core, core->resolve(name));
  core->add(made, group);
  return made;
}

template<class S, class F, class N>
typename Service<S>::SharedPtr create_service(
  N && node, const std::string & name, F && callback, const QoS & = ServicesQoS(),
  CallbackGroup::SharedPtr group = nullptr)
{
  const auto core = detail::core(std::forward<N>(node));
  auto made = std::make_shared<Service<S>>(*core, core->resolve(name), std::decay_t<F>(std::forward<F>(callback)));
  made->start();
  core->add(made, group);
  return made;
}

template<class S>
typename Client<S>::SharedPtr create_client(
  node_interfaces::NodeCore::SharedPtr node, node_interfaces::NodeCore::SharedPtr, node_interfaces::NodeCore::SharedPtr,
  const std::string & name, const QoS & qos = ServicesQoS(), CallbackGroup::SharedPtr group = nullptr)
{
  return create_client<S>(node, name, qos, group);
}
template<class S, class F>
typename Service<S>::SharedPtr create_service(
  node_interfaces::NodeCore::SharedPtr node, node_interfaces::NodeCore::SharedPtr, const std::string & name,
  F && callback, const QoS & qos = ServicesQoS(), CallbackGroup::SharedPtr group = nullptr)
{
  return create_service<S>(node, name, std::forward<F>(callback), qos, group);
}

/// A topic or service name with the namespace and the name of the node; nothing is remapped.
std::string expand_topic_or_service_name(
  const std::string & name, const std::string & node_name, const std::string & node_namespace, bool is_service = false);

}  // namespace rclcpp
