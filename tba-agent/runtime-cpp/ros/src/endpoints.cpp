// Publishers, subscriptions, timers, clients and services.
#include <algorithm>

#include "case.hpp"
#include "rclcpp/create.hpp"

namespace rclcpp {

namespace kernel = sitaf_ros::kernel;
using sitaf_ros::Graph;
using sitaf_ros::Nanos;

namespace {

rmw_qos_policy_kind_t kind_of(const std::string & policy)
{
  return policy == "RELIABILITY" ? RMW_QOS_POLICY_RELIABILITY : policy == "DURABILITY" ? RMW_QOS_POLICY_DURABILITY :
         policy == "DEADLINE" ? RMW_QOS_POLICY_DEADLINE : RMW_QOS_POLICY_LIVELINESS;
}

template<class Status>
std::shared_ptr<sitaf_ros::EventEntity<Status>> event(
  node_interfaces::NodeCore & node, const std::function<void(Status &)> & callback, const std::string & name,
  const CallbackGroup::SharedPtr & group)
{
  if (!callback) {
    return nullptr;
  }
  auto made = std::make_shared<sitaf_ros::EventEntity<Status>>(callback, name);
  node.add(made, group);
  return made;
}

void count_match(const std::shared_ptr<sitaf_ros::EventEntity<MatchedInfo>> & entity, int change)
{
  if (entity == nullptr) {
    return;
  }
  auto & status = entity->status;
  if (change > 0) {
    ++status.total_count;
    ++status.total_count_change;
  }
  status.current_count += change;
  status.current_count_change += change;
  entity->happened();
}

template<class E>
void count_incompatible(const E & entity, const char * policy)
{
  if (entity != nullptr) {
    ++entity->status.total_count;
    ++entity->status.total_count_change;
    entity->status.last_policy_kind = kind_of(policy);
    entity->happened();
  }
}

}  // namespace

PublisherBase::PublisherBase(
  node_interfaces::NodeCore & node, const std::string & topic, const std::string & type, const QoS & qos,
  const PublisherOptionsBase & options)
: qos_(qos), intra_(node.get_use_intra_process_default())
{
  publication_ = std::make_shared<sitaf_ros::Publication>(
    sitaf_ros::Publication{topic, type, qos.sitaf_quality(true), this, node.get_fully_qualified_name()});
  matched_ = event(node, options.event_callbacks.matched_callback, "matched " + topic, options.callback_group);
  incompatible_ = event(
    node, options.event_callbacks.incompatible_qos_callback, "incompatible_qos " + topic, options.callback_group);
  Graph::get().add(publication_);
}

PublisherBase::~PublisherBase() {Graph::get().remove(publication_);}
void PublisherBase::matched(int change) {count_match(matched_, change);}
void PublisherBase::incompatible_with(const char * policy) {count_incompatible(incompatible_, policy);}
void PublisherBase::sitaf_publish(sitaf_ros::Packet packet)
{
  if (sitaf_is_open()) {
    Graph::get().publish(*publication_, std::move(packet));
  }
}

SubscriptionBase::SubscriptionBase(
  node_interfaces::NodeCore & node, const std::string & topic, const std::string & type, const QoS & qos,
  const SubscriptionOptionsBase & options, sitaf_ros::Take take)
: take_(std::move(take)), qos_(qos), ignores_own_(options.ignore_local_publications)
{
  subscribed_ = std::make_shared<sitaf_ros::Subscribed>(
    sitaf_ros::Subscribed{topic, type, qos.sitaf_quality(false), this, node.get_fully_qualified_name()});
  matched_ = event(node, options.event_callbacks.matched_callback, "matched " + topic, options.callback_group);
  incompatible_ = event(
    node, options.event_callbacks.incompatible_qos_callback, "incompatible_qos " + topic, options.callback_group);
  alive_ = event(node, options.event_callbacks.liveliness_callback, "liveliness " + topic, options.callback_group);
  if (topic != "/parameter_events" && topic != "/clock" && topic.find("/_action/") == std::string::npos) {
    name_callback("the callback of the subscription " + topic);
  }
  Graph::get().add(subscribed_);
}

SubscriptionBase::~SubscriptionBase() {Graph::get().remove(subscribed_);}
void SubscriptionBase::matched(int change)
{
  count_match(matched_, change);
  if (alive_ != nullptr) {
    alive(change);
  }
}
void SubscriptionBase::incompatible_with(const char * policy) {count_incompatible(incompatible_, policy);}
void SubscriptionBase::alive(int change)
{
  if (alive_ != nullptr) {
    alive_->status.alive_count += change;
    alive_->status.alive_count_change += change;
    alive_->happened();
  }
}

void SubscriptionBase::receive(const sitaf_ros::Packet & packet)
{
  if (ignores_own_) {
    for (const auto & publication : Graph::get().publications) {
      if (publication->id == packet.publisher && !publication->node.empty()) {
        return;
      }
    }
  }
  queue_.push_back(packet);
  if (!subscribed_->quality.keep_all && queue_.size() > subscribed_->quality.depth) {
    queue_.pop_front();
  }
  if (on_new_) {
    on_new_(1);
  }
}

std::optional<std::pair<int, std::int64_t>> SubscriptionBase::order()
{
  return queue_.empty() ? std::nullopt :
         std::optional<std::pair<int, std::int64_t>>({0, queue_.front().number});
}

bool SubscriptionBase::sitaf_next(sitaf_ros::Packet & packet, MessageInfo & info)
{
  if (queue_.empty()) {
    return false;
  }
  packet = std::move(queue_.front());
  queue_.pop_front();
  rmw_message_info_t raw{};
  raw.source_timestamp = sitaf_ros::EPOCH + packet.time;
  raw.received_timestamp = sitaf_ros::EPOCH + kernel::now();
  raw.publication_sequence_number = static_cast<std::uint64_t>(packet.number);
  raw.reception_sequence_number = ++received_;
  std::memcpy(raw.publisher_gid.data, &packet.publisher, sizeof packet.publisher);
  info = MessageInfo(raw);
  return true;
}

bool SubscriptionBase::take_serialized(SerializedMessage & message, MessageInfo & info)
{
  sitaf_ros::Packet packet;
  if (!sitaf_next(packet, info)) {
    return false;
  }
  message = SerializedMessage(packet.serialized());
  return true;
}

std::function<void()> SubscriptionBase::take()
{
  auto packet = std::make_shared<sitaf_ros::Packet>();
  MessageInfo info;
  if (!sitaf_next(*packet, info)) {
    return {};
  }
  return [this, packet, info] {take_(*packet, info);};
}

// Timers.

TimerBase::TimerBase(
  Clock::SharedPtr clock, std::chrono::nanoseconds period,
  std::function<void(TimerBase &, const TimerInfo &)> callback, bool autostart)
: clock_(std::move(clock)), period_(period.count()), created_(Graph::get().next_number()), canceled_(!autostart),
  callback_(std::move(callback))
{
  if (period_ < 0) {
    throw std::invalid_argument("timer period cannot be negative");
  }
  // A period of zero would be endless callbacks at one instant.
  period_ = std::max<Nanos>(period_, 1);
  if (period_ < 1000) {
    period_ = 1'000'000;
  }
  next_ = kernel::now() + period_;
}

void TimerBase::reset()
{
  canceled_ = false;
  next_ = kernel::now() + period_;
  sitaf_ros::work_appeared();
}
bool TimerBase::is_ready() {return !canceled_ && next_ <= kernel::now();}
std::chrono::nanoseconds TimerBase::time_until_trigger()
{
  return canceled_ ? std::chrono::nanoseconds::max() : std::chrono::nanoseconds(next_ - kernel::now());
}

bool TimerBase::call()
{
  if (canceled_) {
    return false;
  }
  expected_ = next_;
  next_ += period_;
  const Nanos now = kernel::now();
  if (next_ <= now) {
    next_ += (now - next_) / period_ * period_ + period_;
  }
  return true;
}

void TimerBase::execute_callback()
{
  const Nanos base = clock_->ros_time_is_active() ? 0 : sitaf_ros::EPOCH;
  const rcl_clock_type_t type = clock_->get_clock_type();
  callback_(*this, TimerInfo{Time(base + expected_, type), Time(base + kernel::now(), type)});
}

std::optional<std::pair<int, std::int64_t>> TimerBase::order()
{
  return is_ready() ? std::optional<std::pair<int, std::int64_t>>({1, created_}) : std::nullopt;
}
std::optional<Nanos> TimerBase::due() {return canceled_ ? std::nullopt : std::optional<Nanos>(next_);}
std::function<void()> TimerBase::take()
{
  if (!is_ready() || !call()) {
    return {};
  }
  return [this] {execute_callback();};
}

// Clients.

ClientBase::ClientBase(node_interfaces::NodeCore & node, const std::string & name, const std::string & type)
: calling_(std::make_shared<sitaf_ros::Calling>(sitaf_ros::Calling{name, type, node.get_fully_qualified_name()}))
{
  callback_name = "the response of the service " + name;
  Graph::get().add(calling_);
}

ClientBase::~ClientBase() {Graph::get().remove(calling_);}
bool ClientBase::service_is_ready() const
{
  return Graph::get().server(calling_->name, calling_->type) != nullptr;
}

bool ClientBase::wait(Nanos nanos)
{
  const std::optional<Nanos> until =
    nanos < 0 ? std::nullopt : std::optional<Nanos>(kernel::now() + nanos);
  while (!service_is_ready()) {
    if (kernel::ending() || !rclcpp::ok() || (until && kernel::now() >= *until)) {
      return false;
    }
    kernel::wait(&Graph::get().changes, until, true);
  }
  return true;
}

std::int64_t ClientBase::send(sitaf_ros::Packet request)
{
  const std::int64_t id = ++sent_;
  std::weak_ptr<sitaf_ros::Entity> self = shared_from_this();
  Graph::get().call(
    calling_->name, calling_->type, std::move(request), [this, self, id](sitaf_ros::Packet response) {
      if (self.lock() != nullptr) {
        responses_.emplace_back(id, std::move(response));
      }
    });
  return id;
}

std::optional<std::pair<int, std::int64_t>> ClientBase::order()
{
  return responses_.empty() ? std::nullopt :
         std::optional<std::pair<int, std::int64_t>>({0, responses_.front().second.number});
}

std::function<void()> ClientBase::take()
{
  if (responses_.empty()) {
    return {};
  }
  auto response = std::make_shared<std::pair<std::int64_t, sitaf_ros::Packet>>(std::move(responses_.front()));
  responses_.pop_front();
  return [this, response] {handle(response->first, response->second);};
}

// Services.

ServiceBase::ServiceBase(node_interfaces::NodeCore & node, const std::string & name, const std::string & type)
: server_(std::make_shared<sitaf_ros::Server>(sitaf_ros::Server{name, type, nullptr, node.get_fully_qualified_name()}))
{
  callback_name = "the callback of the service " + name;
}

void ServiceBase::begin()
{
  std::weak_ptr<sitaf_ros::Entity> self = shared_from_this();
  server_->ask = [this, self](sitaf_ros::Packet request, sitaf_ros::Respond respond) {
      if (self.lock() != nullptr) {
        open_[++asked_] = std::move(respond);
        requests_.emplace_back(asked_, std::move(request));
      }
    };
  Graph::get().add(server_);
}

ServiceBase::~ServiceBase() {Graph::get().remove(server_);}

std::optional<std::pair<int, std::int64_t>> ServiceBase::order()
{
  return requests_.empty() ? std::nullopt :
         std::optional<std::pair<int, std::int64_t>>({0, requests_.front().second.number});
}

bool ServiceBase::next(sitaf_ros::Packet & request, rmw_request_id_t & id)
{
  if (requests_.empty()) {
    return false;
  }
  id = rmw_request_id_t{};
  id.sequence_number = requests_.front().first;
  request = std::move(requests_.front().second);
  requests_.pop_front();
  return true;
}

std::function<void()> ServiceBase::take()
{
  auto request = std::make_shared<sitaf_ros::Packet>();
  auto id = std::make_shared<rmw_request_id_t>();
  if (!next(*request, *id)) {
    return {};
  }
  return [this, request, id] {handle(id, *request);};
}

void ServiceBase::respond(const rmw_request_id_t & id, sitaf_ros::Packet response)
{
  const auto found = open_.find(id.sequence_number);
  if (found != open_.end()) {
    const auto answer = std::move(found->second);
    open_.erase(found);
    answer(std::move(response));
  }
}

}  // namespace rclcpp
