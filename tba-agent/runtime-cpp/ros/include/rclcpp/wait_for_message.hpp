#pragma once

#include <chrono>
#include <memory>
#include <string>

#include "rclcpp/rclcpp.hpp"

namespace rclcpp {

/// Waits for the next message of a subscription; false if the time is over or the context is shut down.
template<class M, class R = std::int64_t, class P = std::milli>
bool wait_for_message(
  M & out, std::shared_ptr<Subscription<M>> subscription, std::shared_ptr<Context>,
  std::chrono::duration<R, P> time = std::chrono::duration<R, P>(-1))
{
  WaitSet set;
  set.add_subscription(subscription);
  const auto result = set.wait(time);
  set.remove_subscription(subscription);
  MessageInfo info;
  return result.kind() == WaitResultKind::Ready && subscription->take(out, info);
}

template<class M, class R = std::int64_t, class P = std::milli>
bool wait_for_message(
  M & out, Node::SharedPtr node, const std::string & topic,
  std::chrono::duration<R, P> time = std::chrono::duration<R, P>(-1), const QoS & qos = SystemDefaultsQoS())
{
  auto subscription = node->create_subscription<M>(topic, qos, [](const std::shared_ptr<const M>) {});
  return wait_for_message<M, R, P>(out, subscription, node->get_node_base_interface()->get_context(), time);
}

}  // namespace rclcpp
