#pragma once

#include <array>
#include <chrono>
#include <memory>
#include <vector>

#include "rclcpp/executor.hpp"

namespace rclcpp {

enum class WaitResultKind {Ready, Timeout, Empty, Invalid};

class GuardCondition : public sitaf_ros::Entity
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(GuardCondition)
  template<class ... Args>
  explicit GuardCondition(Args && ...) {}
  void trigger()
  {
    number_ = sitaf_ros::Graph::get().next_number();
    sitaf_ros::work_appeared();
  }
  std::optional<std::pair<int, std::int64_t>> order() override
  {
    return number_ == 0 ? std::nullopt : std::optional<std::pair<int, std::int64_t>>({0, number_});
  }
  bool exchange_in_use_by_wait_set_state(bool in_use) {return std::exchange(in_wait_set, in_use);}
  void sitaf_taken() {number_ = 0;}

private:
  std::int64_t number_ = 0;
};

struct SubscriptionWaitSetMask
{
  bool include_subscription = true, include_events = true, include_intra_process_waitable = true;
};

/// What was ready after a wait: the other entries are null, as in rcl.
struct ReadyLists
{
  std::vector<const void *> subscriptions, timers, guard_conditions, clients, services;
  std::size_t size_of_subscriptions = 0, size_of_timers = 0, size_of_guard_conditions = 0, size_of_clients = 0,
    size_of_services = 0;
};

template<class W>
class WaitResult
{
public:
  WaitResult(WaitResultKind kind, W * set)
  : kind_(kind), set_(set) {}
  WaitResultKind kind() const {return kind_;}
  W & get_wait_set() {return *set_;}
  const W & get_wait_set() const {return *set_;}
  std::shared_ptr<TimerBase> peek_next_ready_timer(std::size_t = 0) {return first<TimerBase>(set_->timers_);}
  std::shared_ptr<TimerBase> next_ready_timer() {return taken(first<TimerBase>(set_->timers_));}
  std::shared_ptr<SubscriptionBase> next_ready_subscription()
  {
    return first<SubscriptionBase>(set_->subscriptions_);
  }
  std::shared_ptr<ServiceBase> next_ready_service() {return first<ServiceBase>(set_->services_);}
  std::shared_ptr<ClientBase> next_ready_client() {return first<ClientBase>(set_->clients_);}

private:
  template<class T, class L>
  std::shared_ptr<T> first(L & list)
  {
    for (const auto & entity : list) {
      if (entity->order()) {
        return entity;
      }
    }
    return nullptr;
  }
  static std::shared_ptr<TimerBase> taken(std::shared_ptr<TimerBase> timer)
  {
    if (timer != nullptr) {
      timer->call();
    }
    return timer;
  }

  WaitResultKind kind_;
  W * set_;
};

class WaitSet
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(WaitSet)

  struct SubscriptionEntry
  {
    std::shared_ptr<SubscriptionBase> subscription;
    SubscriptionWaitSetMask mask;
    SubscriptionEntry(std::shared_ptr<SubscriptionBase> given = nullptr, SubscriptionWaitSetMask how = {})
    : subscription(std::move(given)), mask(how) {}
    template<class T>
    SubscriptionEntry(std::shared_ptr<T> given)
    : subscription(std::move(given)) {}
  };

  WaitSet() = default;
  WaitSet(
    const std::vector<SubscriptionEntry> & subscriptions, const std::vector<GuardCondition::SharedPtr> & guards = {},
    const std::vector<TimerBase::SharedPtr> & timers = {}, const std::vector<ClientBase::SharedPtr> & clients = {},
    const std::vector<ServiceBase::SharedPtr> & services = {})
  : guards_(guards), timers_(timers), clients_(clients), services_(services)
  {
    for (const auto & entry : subscriptions) {
      add_subscription(entry.subscription);
    }
    for (const auto & timer : timers_) {
      timer->in_wait_set = true;
    }
  }
  ~WaitSet()
  {
    for (const auto & one : subscriptions_) {
      one->in_wait_set = false;
    }
    for (const auto & one : timers_) {
      one->in_wait_set = false;
    }
  }

  void add_subscription(std::shared_ptr<SubscriptionBase> one, SubscriptionWaitSetMask = {}) {put(subscriptions_, one);}
  void remove_subscription(std::shared_ptr<SubscriptionBase> one, SubscriptionWaitSetMask = {})
  {
    drop(subscriptions_, one);
  }
  void add_timer(std::shared_ptr<TimerBase> one) {put(timers_, one);}
  void remove_timer(std::shared_ptr<TimerBase> one) {drop(timers_, one);}
  void add_guard_condition(std::shared_ptr<GuardCondition> one) {put(guards_, one);}
  void remove_guard_condition(std::shared_ptr<GuardCondition> one) {drop(guards_, one);}
  void add_client(std::shared_ptr<ClientBase> one) {put(clients_, one);}
  void remove_client(std::shared_ptr<ClientBase> one) {drop(clients_, one);}
  void add_service(std::shared_ptr<ServiceBase> one) {put(services_, one);}
  void remove_service(std::shared_ptr<ServiceBase> one) {drop(services_, one);}
  template<class ... Args>
  void add_waitable(Args && ...) {}
  template<class ... Args>
  void remove_waitable(Args && ...) {}
  void prune_deleted_entities() {}

  template<class R = std::int64_t, class P = std::milli>
  WaitResult<WaitSet> wait(std::chrono::duration<R, P> time = std::chrono::duration<R, P>(-1))
  {
    return {wait_for(time.count() < 0 ? -1 : std::chrono::duration_cast<std::chrono::nanoseconds>(time).count()), this};
  }
  const ReadyLists & get_rcl_wait_set() const {return ready_;}

private:
  friend class WaitResult<WaitSet>;
  template<class L, class T>
  static void put(L & list, const T & one)
  {
    one->in_wait_set = true;
    list.push_back(one);
  }
  template<class L, class T>
  static void drop(L & list, const T & one)
  {
    one->in_wait_set = false;
    list.erase(std::remove(list.begin(), list.end(), one), list.end());
  }
  WaitResultKind wait_for(sitaf_ros::Nanos nanos);

  std::vector<std::shared_ptr<SubscriptionBase>> subscriptions_;
  std::vector<std::shared_ptr<GuardCondition>> guards_;
  std::vector<std::shared_ptr<TimerBase>> timers_;
  std::vector<std::shared_ptr<ClientBase>> clients_;
  std::vector<std::shared_ptr<ServiceBase>> services_;
  ReadyLists ready_;
};

using ThreadSafeWaitSet = WaitSet;

template<std::size_t S = 0, std::size_t G = 0, std::size_t T = 0, std::size_t C = 0, std::size_t V = 0, std::size_t W = 0>
class StaticWaitSet : public WaitSet
{
  template<class E, std::size_t N>
  static std::vector<E> listed(const std::array<E, N> & all) {return {all.begin(), all.end()};}

public:
  RCLCPP_SMART_PTR_DEFINITIONS(StaticWaitSet)
  explicit StaticWaitSet(
    const std::array<SubscriptionEntry, S> & subscriptions = {},
    const std::array<GuardCondition::SharedPtr, G> & guards = {},
    const std::array<TimerBase::SharedPtr, T> & timers = {}, const std::array<ClientBase::SharedPtr, C> & clients = {},
    const std::array<ServiceBase::SharedPtr, V> & services = {}, const std::array<std::shared_ptr<void>, W> & = {})
  : WaitSet(listed(subscriptions), listed(guards), listed(timers), listed(clients), listed(services)) {}
};

}  // namespace rclcpp
