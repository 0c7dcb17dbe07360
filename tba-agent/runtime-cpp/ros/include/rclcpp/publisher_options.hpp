// Options of publishers and subscriptions, and the events of their quality of service.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "rclcpp/callback_group.hpp"
#include "rclcpp/qos.hpp"

typedef struct
{
  int total_count, total_count_change;
} rmw_offered_deadline_missed_status_t;
typedef rmw_offered_deadline_missed_status_t rmw_requested_deadline_missed_status_t;
typedef rmw_offered_deadline_missed_status_t rmw_liveliness_lost_status_t;
typedef struct
{
  int alive_count, not_alive_count, alive_count_change, not_alive_count_change;
} rmw_liveliness_changed_status_t;
typedef struct
{
  int total_count, total_count_change;
  rmw_qos_policy_kind_t last_policy_kind;
} rmw_qos_incompatible_event_status_t;
typedef struct
{
  std::size_t total_count, total_count_change;
} rmw_message_lost_status_t;
typedef rmw_offered_deadline_missed_status_t rmw_incompatible_type_status_t;
typedef struct
{
  std::size_t total_count, total_count_change, current_count;
  int current_count_change;
} rmw_matched_status_t;

typedef enum
{
  RMW_UNIQUE_NETWORK_FLOW_ENDPOINTS_NOT_REQUIRED, RMW_UNIQUE_NETWORK_FLOW_ENDPOINTS_STRICTLY_REQUIRED,
  RMW_UNIQUE_NETWORK_FLOW_ENDPOINTS_OPTIONALLY_REQUIRED, RMW_UNIQUE_NETWORK_FLOW_ENDPOINTS_SYSTEM_DEFAULT
} rmw_unique_network_flow_endpoints_requirement_t;
#define RMW_UNIQUE_NETWORK_FLOW_ENDPOINTS_NOT_REQUIRED_ 0

namespace rclcpp {

using QOSDeadlineRequestedInfo = rmw_requested_deadline_missed_status_t;
using QOSDeadlineOfferedInfo = rmw_offered_deadline_missed_status_t;
using QOSLivelinessChangedInfo = rmw_liveliness_changed_status_t;
using QOSLivelinessLostInfo = rmw_liveliness_lost_status_t;
using QOSMessageLostInfo = rmw_message_lost_status_t;
using QOSOfferedIncompatibleQoSInfo = rmw_qos_incompatible_event_status_t;
using QOSRequestedIncompatibleQoSInfo = rmw_qos_incompatible_event_status_t;
using IncompatibleTypeInfo = rmw_incompatible_type_status_t;
using MatchedInfo = rmw_matched_status_t;

struct PublisherEventCallbacks
{
  std::function<void(QOSDeadlineOfferedInfo &)> deadline_callback;
  std::function<void(QOSLivelinessLostInfo &)> liveliness_callback;
  std::function<void(QOSOfferedIncompatibleQoSInfo &)> incompatible_qos_callback;
  std::function<void(IncompatibleTypeInfo &)> incompatible_type_callback;
  std::function<void(MatchedInfo &)> matched_callback;
};

struct SubscriptionEventCallbacks
{
  std::function<void(QOSDeadlineRequestedInfo &)> deadline_callback;
  std::function<void(QOSLivelinessChangedInfo &)> liveliness_callback;
  std::function<void(QOSRequestedIncompatibleQoSInfo &)> incompatible_qos_callback;
  std::function<void(QOSMessageLostInfo &)> message_lost_callback;
  std::function<void(IncompatibleTypeInfo &)> incompatible_type_callback;
  std::function<void(MatchedInfo &)> matched_callback;
};

struct QosCallbackResult
{
  bool successful = false;
  std::string reason;
};

class QosOverridingOptions
{
public:
  QosOverridingOptions() = default;
  QosOverridingOptions(
    std::initializer_list<QosPolicyKind> kinds, std::function<QosCallbackResult(const QoS &)> = nullptr,
    std::string name = {})
  : kinds_(kinds), id_(std::move(name)) {}
  static QosOverridingOptions with_default_policies(
    std::function<QosCallbackResult(const QoS &)> = nullptr, std::string id = {})
  {
    return QosOverridingOptions({QosPolicyKind::History, QosPolicyKind::Depth, QosPolicyKind::Reliability}, nullptr, id);
  }
  const std::string & get_id() const {return id_;}
  const std::vector<QosPolicyKind> & get_policy_kinds() const {return kinds_;}

private:
  std::vector<QosPolicyKind> kinds_;
  std::string id_;
};

enum class IntraProcessSetting {Enable, Disable, NodeDefault};
enum class IntraProcessBufferType {SharedPtr, UniquePtr, CallbackDefault};
enum class TopicStatisticsState {Enable, Disable, NodeDefault};

struct PublisherOptionsBase
{
  IntraProcessSetting use_intra_process_comm = IntraProcessSetting::NodeDefault;
  IntraProcessBufferType intra_process_buffer_type = IntraProcessBufferType::CallbackDefault;
  PublisherEventCallbacks event_callbacks;
  bool use_default_callbacks = true;
  rmw_unique_network_flow_endpoints_requirement_t require_unique_network_flow_endpoints{};
  std::shared_ptr<CallbackGroup> callback_group;
  QosOverridingOptions qos_overriding_options;
};

struct ContentFilterOptions
{
  std::string filter_expression;
  std::vector<std::string> expression_parameters;
};

struct TopicStatisticsOptions
{
  TopicStatisticsState state = TopicStatisticsState::NodeDefault;
  std::string publish_topic = "/statistics";
  std::chrono::milliseconds publish_period{1000};
  QoS qos = SystemDefaultsQoS();
};

struct SubscriptionOptionsBase
{
  SubscriptionEventCallbacks event_callbacks;
  bool use_default_callbacks = true;
  bool ignore_local_publications = false;
  rmw_unique_network_flow_endpoints_requirement_t require_unique_network_flow_endpoints{};
  std::shared_ptr<CallbackGroup> callback_group;
  IntraProcessSetting use_intra_process_comm = IntraProcessSetting::NodeDefault;
  IntraProcessBufferType intra_process_buffer_type = IntraProcessBufferType::CallbackDefault;
  TopicStatisticsOptions topic_stats_options;
  QosOverridingOptions qos_overriding_options;
  ContentFilterOptions content_filter_options;
};

template<class Allocator>
struct PublisherOptionsWithAllocator : PublisherOptionsBase
{
  std::shared_ptr<Allocator> allocator;
  PublisherOptionsWithAllocator() = default;
  explicit PublisherOptionsWithAllocator(const PublisherOptionsBase & base)
  : PublisherOptionsBase(base) {}
  std::shared_ptr<Allocator> get_allocator() const {return allocator ? allocator : std::make_shared<Allocator>();}
};

template<class Allocator>
struct SubscriptionOptionsWithAllocator : SubscriptionOptionsBase
{
  std::shared_ptr<Allocator> allocator;
  SubscriptionOptionsWithAllocator() = default;
  explicit SubscriptionOptionsWithAllocator(const SubscriptionOptionsBase & base)
  : SubscriptionOptionsBase(base) {}
  std::shared_ptr<Allocator> get_allocator() const {return allocator ? allocator : std::make_shared<Allocator>();}
};

using PublisherOptions = PublisherOptionsWithAllocator<std::allocator<void>>;
using SubscriptionOptions = SubscriptionOptionsWithAllocator<std::allocator<void>>;

}  // namespace rclcpp

namespace sitaf_ros {

/// Calls an executor of what a publisher or subscription has to tell its user.
template<class Status>
class EventEntity : public Entity
{
public:
  EventEntity(std::function<void(Status &)> callback, const std::string & name)
  : callback_(std::move(callback)) {callback_name = name;}

  Status status{};
  void happened()
  {
    number_ = Graph::get().next_number();
    work_appeared();
  }
  std::optional<std::pair<int, std::int64_t>> order() override
  {
    return number_ == 0 ? std::nullopt : std::optional<std::pair<int, std::int64_t>>({0, number_});
  }
  std::function<void()> take() override
  {
    number_ = 0;
    Status now = status;
    clear();
    return [this, now]() mutable {callback_(now);};
  }

private:
  void clear();
  std::function<void(Status &)> callback_;
  std::int64_t number_ = 0;
};

template<class Status>
void EventEntity<Status>::clear()
{
  if constexpr (std::is_same_v<Status, rmw_matched_status_t>) {
    status.total_count_change = 0;
    status.current_count_change = 0;
  } else if constexpr (std::is_same_v<Status, rmw_liveliness_changed_status_t>) {
    status.alive_count_change = status.not_alive_count_change = 0;
  } else {
    status.total_count_change = 0;
  }
}

}  // namespace sitaf_ros
