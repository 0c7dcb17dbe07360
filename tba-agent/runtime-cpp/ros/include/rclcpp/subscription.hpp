#pragma once

#include <deque>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "rclcpp/publisher.hpp"

namespace sitaf_ros {

using Take = std::function<void(Packet &, const rclcpp::MessageInfo &)>;

template<class T>
std::unique_ptr<typename Adapted<T>::Custom> own(Packet & packet)
{
  using Ros = typename Adapted<T>::Ros;
  if constexpr (Adapted<T>::adapts) {
    auto made = std::make_unique<typename Adapted<T>::Custom>();
    Adapted<T>::Adapter::convert_to_custom(*packet.shared<Ros>(), *made);
    return made;
  } else {
    return std::make_unique<Ros>(*packet.shared<Ros>());
  }
}

/// Calls a callback of any of the forms that ROS accepts, with further arguments that it may take.
template<class T, class F, class ... More>
bool call_with(F & f, Packet & packet, const More & ... more)
{
  using Ros = typename Adapted<T>::Ros;
  using Custom = typename Adapted<T>::Custom;
  using rclcpp::SerializedMessage;
  if constexpr (std::is_invocable_v<F &, const Custom &, const More &...>) {
    if constexpr (Adapted<T>::adapts) {
      f(*own<T>(packet), more ...);
    } else {
      f(*packet.shared<Ros>(), more ...);
    }
  } else if constexpr (!Adapted<T>::adapts && std::is_invocable_v<F &, std::shared_ptr<const Ros>, const More &...>) {
    f(packet.shared<Ros>(), more ...);
  } else if constexpr (std::is_invocable_v<F &, std::unique_ptr<Custom>, const More &...>) {
    f(own<T>(packet), more ...);
  } else if constexpr (std::is_invocable_v<F &, std::shared_ptr<Custom>, const More &...>) {
    f(std::shared_ptr<Custom>(own<T>(packet)), more ...);
  } else if constexpr (std::is_invocable_v<F &, const Ros &, const More &...>) {
    f(*packet.shared<Ros>(), more ...);
  } else if constexpr (std::is_invocable_v<F &, std::unique_ptr<Ros>, const More &...>) {
    f(std::make_unique<Ros>(*packet.shared<Ros>()), more ...);
  } else if constexpr (std::is_invocable_v<F &, const SerializedMessage &, const More &...>) {
    f(SerializedMessage(packet.serialized()), more ...);
  } else if constexpr (std::is_invocable_v<F &, std::unique_ptr<SerializedMessage>, const More &...>) {
    f(std::make_unique<SerializedMessage>(packet.serialized()), more ...);
  } else {
    return false;
  }
  return true;
}

/// Whether `call_with` can call it.
template<class T, class F, class ... More>
constexpr bool takes()
{
  using Ros = typename Adapted<T>::Ros;
  using Custom = typename Adapted<T>::Custom;
  using rclcpp::SerializedMessage;
  return std::is_invocable_v<F &, const Custom &, const More &...> ||
         std::is_invocable_v<F &, std::unique_ptr<Custom>, const More &...> ||
         std::is_invocable_v<F &, std::shared_ptr<Custom>, const More &...> ||
         std::is_invocable_v<F &, const Ros &, const More &...> ||
         std::is_invocable_v<F &, std::unique_ptr<Ros>, const More &...> ||
         std::is_invocable_v<F &, const SerializedMessage &, const More &...> ||
         std::is_invocable_v<F &, std::unique_ptr<SerializedMessage>, const More &...>;
}

template<class T, class F>
Take taker(F callback)
{
  return [callback = std::move(callback)](Packet & packet, const rclcpp::MessageInfo & info) mutable {
      if constexpr (takes<T, F>()) {
        call_with<T>(callback, packet);
      } else {
        static_assert(
          takes<T, F, rclcpp::MessageInfo>(),
          "the callback of a subscription takes a message (const reference, shared or unique pointer), and a MessageInfo");
        call_with<T>(callback, packet, info);
      }
    };
}

/// Evaluates filters of topics: `data >= 10`, `data = 'a'`, with `%0` for parameters, AND, OR, NOT, BETWEEN and LIKE.
class ContentFilter;

}  // namespace sitaf_ros

namespace rclcpp {

class SubscriptionBase : public sitaf_ros::Endpoint, public sitaf_ros::Entity
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(SubscriptionBase)

  SubscriptionBase(
    node_interfaces::NodeCore & node, const std::string & topic, const std::string & type, const QoS & qos,
    const SubscriptionOptionsBase & options, sitaf_ros::Take take);
  ~SubscriptionBase() override;

  const char * get_topic_name() const {return subscribed_->topic.c_str();}
  QoS get_actual_qos() const {return qos_;}
  std::size_t get_publisher_count() const {return sitaf_ros::Graph::get().publishers_for(*subscribed_);}
  bool can_loan_messages() const {return false;}
  bool is_cft_enabled() const {return false;}
  bool is_serialized() const {return false;}
  void set_content_filter(const std::string &, const std::vector<std::string> & = {})
  {
    throw exceptions::RCLError("failed to set cft expression parameters: content filters are not simulated");
  }
  ContentFilterOptions get_content_filter() const
  {
    throw exceptions::RCLError("failed to get cft expression parameters: content filters are not simulated");
  }
  std::vector<NetworkFlowEndpoint> get_network_flow_endpoints() const {return {};}
  bool take_serialized(SerializedMessage & message, MessageInfo & info);
  std::shared_ptr<SubscriptionBase> get_subscription_handle()
  {
    return std::static_pointer_cast<SubscriptionBase>(sitaf_ros::Entity::shared_from_this());
  }
  bool exchange_in_use_by_wait_set_state(void *, bool in_use) {return std::exchange(in_wait_set, in_use);}
  template<class F>
  void set_on_new_message_callback(F callback) {on_new_ = callback;}
  void clear_on_new_message_callback() {on_new_ = nullptr;}
  template<class ... Args>
  void set_on_new_qos_event_callback(Args && ...) {}

  void receive(const sitaf_ros::Packet & packet) override;
  void matched(int change) override;
  void incompatible_with(const char * policy) override;
  void alive(int change) override;
  std::optional<std::pair<int, std::int64_t>> order() override;
  std::function<void()> take() override;
  std::shared_ptr<void> create_message() const {return nullptr;}

protected:
  bool sitaf_next(sitaf_ros::Packet & packet, MessageInfo & info);
  sitaf_ros::Take take_;

private:
  std::shared_ptr<sitaf_ros::Subscribed> subscribed_;
  QoS qos_;
  bool ignores_own_;
  std::deque<sitaf_ros::Packet> queue_;
  std::function<void(std::size_t)> on_new_;
  std::uint64_t received_ = 0;
  std::shared_ptr<sitaf_ros::EventEntity<MatchedInfo>> matched_;
  std::shared_ptr<sitaf_ros::EventEntity<QOSRequestedIncompatibleQoSInfo>> incompatible_;
  std::shared_ptr<sitaf_ros::EventEntity<QOSLivelinessChangedInfo>> alive_;
};

template<
  class T, class A = std::allocator<void>, class Subscribed = typename sitaf_ros::Adapted<T>::Custom,
  class Ros = typename sitaf_ros::Adapted<T>::Ros, class Strategy = void>
class Subscription : public SubscriptionBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Subscription<T, A, Subscribed, Ros, Strategy>)
  using SubscribedType = Subscribed;
  using ROSMessageType = Ros;
  using SubscriptionBase::SubscriptionBase;
  using SubscriptionBase::take;

  bool take(Subscribed & message, MessageInfo & info)
  {
    sitaf_ros::Packet packet;
    if (!sitaf_next(packet, info)) {
      return false;
    }
    message = std::move(*sitaf_ros::own<T>(packet));
    return true;
  }
  bool take_type_erased(void * message, MessageInfo & info)
  {
    sitaf_ros::Packet packet;
    if (!sitaf_next(packet, info)) {
      return false;
    }
    *static_cast<Ros *>(message) = *packet.template shared<Ros>();
    return true;
  }
  std::shared_ptr<void> create_message() const {return std::make_shared<Ros>();}
  void handle_message(std::shared_ptr<void> & message, const MessageInfo & info)
  {
    sitaf_ros::Packet packet = sitaf_ros::packet<Ros>(std::static_pointer_cast<const Ros>(message));
    take_(packet, info);
  }
};

class GenericSubscription : public SubscriptionBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(GenericSubscription)
  using SubscriptionBase::SubscriptionBase;
};

namespace message_memory_strategy {

template<class M, class A = std::allocator<void>>
class MessageMemoryStrategy
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(MessageMemoryStrategy)
  template<class ... Args>
  explicit MessageMemoryStrategy(Args && ...) {}
};

}  // namespace message_memory_strategy
}  // namespace rclcpp
