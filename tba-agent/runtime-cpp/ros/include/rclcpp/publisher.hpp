#pragma once

#include <memory>
#include <string>
#include <vector>

#include "rclcpp/node_core.hpp"
#include "rclcpp/serialized_message.hpp"
#include "rclcpp/type_adapter.hpp"

namespace rclcpp {

class NetworkFlowEndpoint {};
inline std::ostream & operator<<(std::ostream & out, const NetworkFlowEndpoint &) {return out << "{}";}

class PublisherBase : public sitaf_ros::Endpoint
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(PublisherBase)

  PublisherBase(
    node_interfaces::NodeCore & node, const std::string & topic, const std::string & type, const QoS & qos,
    const PublisherOptionsBase & options);
  ~PublisherBase() override;

  const char * get_topic_name() const {return publication_->topic.c_str();}
  std::size_t get_queue_size() const {return qos_.depth();}
  std::size_t get_subscription_count() const {return sitaf_ros::Graph::get().subscribers_for(*publication_);}
  std::size_t get_intra_process_subscription_count() const {return intra_ ? get_subscription_count() : 0;}
  QoS get_actual_qos() const {return qos_;}
  bool can_loan_messages() const {return false;}
  bool assert_liveliness() const {return true;}
  template<class R = std::int64_t, class P = std::milli>
  bool wait_for_all_acked(std::chrono::duration<R, P> = std::chrono::duration<R, P>(-1)) const {return true;}
  std::vector<NetworkFlowEndpoint> get_network_flow_endpoints() const {return {};}
  rmw_gid_t get_gid() const
  {
    rmw_gid_t gid{};
    std::memcpy(gid.data, &publication_->id, sizeof publication_->id);
    return gid;
  }
  bool operator==(const rmw_gid_t & gid) const {return std::memcmp(get_gid().data, gid.data, sizeof gid.data) == 0;}
  template<class ... Args>
  void set_on_new_qos_event_callback(Args && ...) {}

  void matched(int change) override;
  void incompatible_with(const char * policy) override;
  void sitaf_publish(sitaf_ros::Packet packet);
  /// Whether messages leave the node; those of a lifecycle node only while it is active.
  virtual bool sitaf_is_open() {return true;}

protected:
  std::shared_ptr<sitaf_ros::Publication> publication_;

private:
  QoS qos_;
  bool intra_;
  std::shared_ptr<sitaf_ros::EventEntity<MatchedInfo>> matched_;
  std::shared_ptr<sitaf_ros::EventEntity<QOSOfferedIncompatibleQoSInfo>> incompatible_;
};

template<class M, class A = std::allocator<void>>
class LoanedMessage
{
public:
  explicit LoanedMessage(std::unique_ptr<M> message)
  : message_(std::move(message)) {}
  bool is_valid() const {return message_ != nullptr;}
  M & get() const {return *message_;}
  std::unique_ptr<M> release() {return std::move(message_);}

private:
  std::unique_ptr<M> message_;
};

template<class T, class A = std::allocator<void>>
class Publisher : public PublisherBase
{
  using Adapted = sitaf_ros::Adapted<T>;

public:
  RCLCPP_SMART_PTR_DEFINITIONS(Publisher<T, A>)

  using PublishedType = typename Adapted::Custom;
  using ROSMessageType = typename Adapted::Ros;
  using MessageAllocator = typename std::allocator_traits<A>::template rebind_alloc<ROSMessageType>;
  using MessageUniquePtr = std::unique_ptr<ROSMessageType>;
  using MessageSharedPtr = std::shared_ptr<const ROSMessageType>;

  Publisher(
    node_interfaces::NodeCore & node, const std::string & topic, const QoS & qos, const PublisherOptionsBase & options)
  : PublisherBase(node, topic, ROSMessageType::sitaf_name, qos, options) {}
  Publisher(
    node_interfaces::NodeCore * node, const std::string & topic, const QoS & qos,
    const PublisherOptionsWithAllocator<A> & options)
  : Publisher(*node, topic, qos, options) {}

  template<class P, class D>
  void publish(std::unique_ptr<P, D> message) {publish(*message);}
  void publish(LoanedMessage<ROSMessageType, A> && message) {publish(message.get());}
  void publish(const SerializedMessage & message) {publish_bytes(message.get());}
  void publish(const rcl_serialized_message_t & message)
  {
    publish_bytes(sitaf_ros::Bytes(message.buffer, message.buffer + message.buffer_length));
  }
  void publish(const ROSMessageType & message)
  {
    sitaf_publish(sitaf_ros::packet<ROSMessageType>(std::make_shared<const ROSMessageType>(message)));
  }
  template<class C>
  std::enable_if_t<Adapted::adapts && std::is_same_v<C, PublishedType>> publish(const C & custom)
  {
    auto message = std::make_shared<ROSMessageType>();
    Adapted::Adapter::convert_to_ros_message(custom, *message);
    sitaf_publish(sitaf_ros::packet<ROSMessageType>(std::move(message)));
  }
  LoanedMessage<ROSMessageType, A> borrow_loaned_message()
  {
    return LoanedMessage<ROSMessageType, A>(std::make_unique<ROSMessageType>());
  }

private:
  void publish_bytes(sitaf_ros::Bytes bytes)
  {
    sitaf_ros::Packet packet;
    packet.bytes = std::make_shared<const sitaf_ros::Bytes>(std::move(bytes));
    sitaf_publish(std::move(packet));
  }
};

class GenericPublisher : public PublisherBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(GenericPublisher)
  using PublisherBase::PublisherBase;
  void publish(const SerializedMessage & message)
  {
    sitaf_ros::Packet packet;
    packet.bytes = std::make_shared<const sitaf_ros::Bytes>(message.get());
    sitaf_publish(std::move(packet));
  }
};

}  // namespace rclcpp
