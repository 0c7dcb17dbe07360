// Subscribers, caches and synchronizers of messages.
#pragma once

#include <array>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "rclcpp/rclcpp.hpp"

namespace message_filters {

namespace message_traits {

template<class M, class = void>
struct HasHeader : std::false_type {};
template<class M>
struct HasHeader<M, std::void_t<decltype(std::declval<M>().header.stamp)>> : std::true_type {};
template<class M, class = void>
struct TimeStamp;
template<class M>
struct TimeStamp<M, std::enable_if_t<HasHeader<M>::value>>
{
  static rclcpp::Time value(const M & message) {return rclcpp::Time(message.header.stamp, RCL_ROS_TIME);}
};

}  // namespace message_traits

class Connection
{
public:
  Connection() = default;
  explicit Connection(std::function<void()> end)
  : end_(std::move(end)) {}
  void disconnect()
  {
    if (end_) {
      end_();
    }
  }

private:
  std::function<void()> end_;
};

/// A message, and when it was received.
template<class M>
class MessageEvent
{
public:
  using Message = std::remove_const_t<M>;
  using ConstMessagePtr = std::shared_ptr<const Message>;

  MessageEvent() = default;
  MessageEvent(ConstMessagePtr message)
  : MessageEvent(std::move(message), rclcpp::Clock(RCL_ROS_TIME).now()) {}
  MessageEvent(ConstMessagePtr message, rclcpp::Time received)
  : message_(std::move(message)), received_(received) {}
  template<class Other, class = std::enable_if_t<std::is_same_v<std::remove_const_t<Other>, Message>>>
  MessageEvent(const MessageEvent<Other> & other)
  : MessageEvent(other.getConstMessage(), other.getReceiptTime()) {}
  /// The message; a copy where it may be changed.
  std::shared_ptr<M> getMessage() const
  {
    if constexpr (std::is_const_v<M>) {
      return message_;
    } else {
      return message_ == nullptr ? nullptr : std::make_shared<M>(*message_);
    }
  }
  ConstMessagePtr getConstMessage() const {return message_;}
  rclcpp::Time getReceiptTime() const {return received_;}

private:
  ConstMessagePtr message_;
  rclcpp::Time received_;
};

struct NullType {};

template<class M>
class SimpleFilter
{
public:
  using MConstPtr = std::shared_ptr<const M>;
  virtual ~SimpleFilter() = default;

  template<class F>
  Connection registerCallback(F callback)
  {
    const int id = ++count_;
    (*callbacks_)[id] = [callback](const MConstPtr & message) mutable {
        if constexpr (std::is_invocable_v<F &, const MConstPtr &>) {
          callback(message);
        } else if constexpr (std::is_invocable_v<F &, const M &>) {
          callback(*message);
        } else {
          callback(MessageEvent<const M>(message));
        }
      };
    auto callbacks = callbacks_;
    return Connection([callbacks, id] {callbacks->erase(id);});
  }
  template<class T, class P>
  Connection registerCallback(void (T::* method)(P), T * object)
  {
    return registerCallback([object, method](const MConstPtr & message) {(object->*method)(message);});
  }
  void setName(const std::string & name) {name_ = name;}
  const std::string & getName() const {return name_;}

protected:
  void signalMessage(const MConstPtr & message)
  {
    for (const auto & [id, callback] : std::map(*callbacks_)) {
      (void)id;
      callback(message);
    }
  }

private:
  std::shared_ptr<std::map<int, std::function<void(const MConstPtr &)>>> callbacks_ =
    std::make_shared<std::map<int, std::function<void(const MConstPtr &)>>>();
  int count_ = 0;
  std::string name_;
};

/// Subscribers are the first filters of a chain: they have no input.
struct SubscriberMark {};

/// What subscribers of different messages have in common.
template<class N = rclcpp::Node>
class SubscriberBase : public SubscriberMark
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(SubscriberBase)
  using NodePtr = std::shared_ptr<N>;
  virtual ~SubscriberBase() = default;
  virtual void subscribe() = 0;
  virtual void unsubscribe() = 0;
};

template<class M, class N = rclcpp::Node>
class Subscriber : public SubscriberBase<N>, public SimpleFilter<M>
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Subscriber)
  using MessageType = M;
  using EventType = MessageEvent<const M>;

  Subscriber() = default;
  template<class T>
  Subscriber(T && node, const std::string & topic) {subscribe(std::forward<T>(node), topic);}
  template<class T, class Q>
  Subscriber(T && node, const std::string & topic, const Q & qos) {subscribe(std::forward<T>(node), topic, qos);}
  template<class T, class Q>
  Subscriber(T && node, const std::string & topic, const Q & qos, rclcpp::SubscriptionOptions options)
  {
    subscribe(std::forward<T>(node), topic, qos, options);
  }
  template<class T>
  void subscribe(T && node, const std::string & topic) {begin(rclcpp::detail::core(node), topic, rclcpp::QoS(10), {});}
  template<class T>
  void subscribe(
    T && node, const std::string & topic, const rmw_qos_profile_t & profile,
    const rclcpp::SubscriptionOptions & options = {})
  {
    begin(rclcpp::detail::core(node), topic, rclcpp::QoS(rclcpp::QoSInitialization::from_rmw(profile), profile), options);
  }
  template<class T>
  void subscribe(
    T && node, const std::string & topic, const rclcpp::QoS & qos, const rclcpp::SubscriptionOptions & options = {})
  {
    begin(rclcpp::detail::core(node), topic, qos, options);
  }
  void subscribe() override
  {
    if (again_) {
      again_();
    }
  }
  void unsubscribe() override {subscription_.reset();}
  std::string getTopic() const {return topic_;}
  const typename rclcpp::Subscription<M>::SharedPtr getSubscriber() const {return subscription_;}
  template<class F>
  void connectInput(F &) {}

private:
  void begin(
    const rclcpp::node_interfaces::NodeCore::SharedPtr & node, const std::string & topic, const rclcpp::QoS & qos,
    const rclcpp::SubscriptionOptions & options)
  {
    topic_ = topic;
    again_ = [this, node = node.get(), topic, qos, options] {
        subscription_ = rclcpp::create_subscription<M>(
          node, topic, qos, [this](const std::shared_ptr<const M> message) {this->signalMessage(message);}, options);
      };
    again_();
  }

  std::string topic_;
  std::function<void()> again_;
  typename rclcpp::Subscription<M>::SharedPtr subscription_;
};

template<class M>
class PassThrough : public SimpleFilter<M>
{
public:
  using MessageType = M;
  PassThrough() = default;
  template<class F>
  explicit PassThrough(F & filter) {connectInput(filter);}
  template<class F>
  void connectInput(F & filter)
  {
    connection_ = filter.registerCallback([this](const std::shared_ptr<const M> & message) {add(message);});
  }
  void add(const std::shared_ptr<const M> & message) {this->signalMessage(message);}
  void add(const MessageEvent<M> & event) {add(event.getMessage());}

private:
  Connection connection_;
};

template<class M>
class Cache : public SimpleFilter<M>
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Cache)
  using Ptr_ = std::shared_ptr<const M>;
  template<class F>
  explicit Cache(F & filter, unsigned size = 1)
  : size_(size) {connectInput(filter);}
  explicit Cache(unsigned size = 1)
  : size_(size) {}
  template<class F>
  void connectInput(F & filter)
  {
    filter.registerCallback([this](const Ptr_ & message) {add(message);});
  }
  void setCacheSize(unsigned size) {size_ = std::max(1u, size);}
  void add(const Ptr_ & message)
  {
    auto at = kept_.end();
    while (at != kept_.begin() && stamp(*std::prev(at)) > stamp(message)) {
      --at;
    }
    kept_.insert(at, message);
    if (kept_.size() > size_) {
      kept_.pop_front();
    }
    this->signalMessage(message);
  }
  std::vector<Ptr_> getInterval(const rclcpp::Time & start, const rclcpp::Time & end) const
  {
    std::vector<Ptr_> found;
    for (const auto & one : kept_) {
      if (stamp(one) >= start && stamp(one) <= end) {
        found.push_back(one);
      }
    }
    return found;
  }
  /// From the last message at or before the start to the first one at or after the end.
  std::vector<Ptr_> getSurroundingInterval(const rclcpp::Time & start, const rclcpp::Time & end) const
  {
    if (kept_.empty()) {
      return {};
    }
    std::size_t first = kept_.size() - 1, last = 0;
    while (first > 0 && stamp(kept_[first]) > start) {
      --first;
    }
    last = first;
    while (last + 1 < kept_.size() && stamp(kept_[last]) < end) {
      ++last;
    }
    return std::vector<Ptr_>(kept_.begin() + first, kept_.begin() + last + 1);
  }
  Ptr_ getElemBeforeTime(const rclcpp::Time & time) const
  {
    Ptr_ found;
    for (const auto & one : kept_) {
      if (stamp(one) < time) {
        found = one;
      }
    }
    return found;
  }
  Ptr_ getElemAfterTime(const rclcpp::Time & time) const
  {
    for (const auto & one : kept_) {
      if (stamp(one) > time) {
        return one;
      }
    }
    return nullptr;
  }
  rclcpp::Time getLatestTime() const {return kept_.empty() ? rclcpp::Time(0, 0, RCL_ROS_TIME) : stamp(kept_.back());}
  rclcpp::Time getOldestTime() const {return kept_.empty() ? rclcpp::Time(0, 0, RCL_ROS_TIME) : stamp(kept_.front());}

private:
  static rclcpp::Time stamp(const Ptr_ & message) {return message_traits::TimeStamp<M>::value(*message);}
  std::deque<Ptr_> kept_;
  std::size_t size_;
};

/// Passes messages on in the order of their stamps, each a fixed delay after its stamp. Messages that arrive later are dropped.
template<class M>
class TimeSequencer : public SimpleFilter<M>
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(TimeSequencer)
  using MConstPtr = std::shared_ptr<const M>;
  using EventType = MessageEvent<const M>;

  template<class F, class N>
  TimeSequencer(F & filter, rclcpp::Duration delay, rclcpp::Duration period, std::uint32_t queue, N && node)
  : TimeSequencer(delay, period, queue, std::forward<N>(node)) {connectInput(filter);}
  template<class N>
  TimeSequencer(rclcpp::Duration delay, rclcpp::Duration period, std::uint32_t queue, N && node)
  : delay_(delay), queue_(queue)
  {
    const auto core = rclcpp::detail::core(std::forward<N>(node));
    clock_ = core->get_clock();
    timer_ = rclcpp::create_timer(core, clock_, period, [this] {dispatch();});
  }
  template<class F>
  void connectInput(F & filter)
  {
    input_.disconnect();
    input_ = filter.registerCallback([this](const MConstPtr & message) {add(message);});
  }
  ~TimeSequencer() override {input_.disconnect();}
  void add(const EventType & event) {add(event.getMessage());}
  void add(const MConstPtr & message)
  {
    const rclcpp::Time time = stamp(message);
    if (last_ && time.nanoseconds() < *last_) {
      return;
    }
    auto at = kept_.end();
    while (at != kept_.begin() && stamp(*std::prev(at)) > time) {
      --at;
    }
    kept_.insert(at, message);
    if (queue_ != 0 && kept_.size() > queue_) {
      kept_.pop_front();
    }
  }

private:
  static rclcpp::Time stamp(const MConstPtr & message) {return message_traits::TimeStamp<M>::value(*message);}
  void dispatch()
  {
    while (!kept_.empty() && (stamp(kept_.front()) + delay_).nanoseconds() <= clock_->now().nanoseconds()) {
      const MConstPtr message = kept_.front();
      kept_.pop_front();
      last_ = stamp(message).nanoseconds();
      this->signalMessage(message);
    }
  }

  rclcpp::Duration delay_;
  std::uint32_t queue_;
  rclcpp::Clock::SharedPtr clock_;
  rclcpp::TimerBase::SharedPtr timer_;
  std::deque<MConstPtr> kept_;
  std::optional<std::int64_t> last_;
  Connection input_;
};

/// Filters in a row; the messages of the last one leave the chain.
template<class M>
class Chain : public SimpleFilter<M>
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Chain)
  using MConstPtr = std::shared_ptr<const M>;
  using EventType = MessageEvent<const M>;

  Chain() = default;
  template<class F>
  explicit Chain(F & filter) {connectInput(filter);}
  ~Chain() override {input_.disconnect();}
  template<class F>
  std::size_t addFilter(F * filter) {return addFilter(std::shared_ptr<F>(filter, [](F *) {}));}
  template<class F>
  std::size_t addFilter(const std::shared_ptr<F> & filter)
  {
    if (!filters_.empty()) {
      filter->connectInput(*last_);
    }
    output_.disconnect();
    output_ = filter->registerCallback([this](const MConstPtr & message) {this->signalMessage(message);});
    if constexpr (!std::is_base_of_v<SubscriberMark, F>) {
      if (filters_.empty()) {
        first_ = [filter](const MConstPtr & message) {filter->add(message);};
      }
    }
    last_ = filter.get();
    filters_.push_back(filter);
    return filters_.size() - 1;
  }
  template<class F>
  std::shared_ptr<F> getFilter(std::size_t index) const
  {
    return index < filters_.size() ? std::static_pointer_cast<F>(filters_[index]) : nullptr;
  }
  template<class F>
  void connectInput(F & filter)
  {
    input_.disconnect();
    input_ = filter.registerCallback([this](const MConstPtr & message) {add(message);});
  }
  void add(const EventType & event) {add(event.getMessage());}
  void add(const MConstPtr & message)
  {
    if (first_) {
      first_(message);
    }
  }

private:
  std::vector<std::shared_ptr<void>> filters_;
  SimpleFilter<M> * last_ = nullptr;
  std::function<void(const MConstPtr &)> first_;
  Connection input_, output_;
};

namespace sync_policies {

/// What the policies share: the queues of messages.
template<class ... Ms>
struct Policy
{
  static constexpr std::size_t size = sizeof...(Ms);
  using Messages = std::tuple<Ms...>;
  using Set = std::tuple<std::shared_ptr<const Ms>...>;
  using Emit = std::function<void (const Set &)>;
};

template<class ... Ms>
class ExactTime : public Policy<Ms...>
{
public:
  using Set = typename Policy<Ms...>::Set;
  ExactTime(std::uint32_t queue)  // Not explicit: a synchronizer is made from the size of its queue.
  : queue_(queue) {}

  template<std::size_t I, class P>
  void add(const P & message, const typename Policy<Ms...>::Emit & emit)
  {
    using M = std::tuple_element_t<I, std::tuple<Ms...>>;
    const std::int64_t time = message_traits::TimeStamp<M>::value(*message).nanoseconds();
    auto & set = sets_[time];
    std::get<I>(set) = message;
    const bool whole = std::apply([](const auto & ... one) {return (... && (one != nullptr));}, set);
    if (whole) {
      const Set found = set;
      sets_.erase(sets_.begin(), sets_.upper_bound(time));
      emit(found);
    } else if (queue_ > 0 && sets_.size() > queue_) {
      sets_.erase(sets_.begin());
    }
  }

private:
  std::uint32_t queue_;
  std::map<std::int64_t, Set> sets_;
};

/// Sets of messages with the smallest span of their stamps, each message at most once.
template<class ... Ms>
class ApproximateTime : public Policy<Ms...>
{
public:
  using Set = typename Policy<Ms...>::Set;
  ApproximateTime(std::uint32_t queue)  // Not explicit: a synchronizer is made from the size of its queue.
  : queue_(std::max(1u, queue)) {}
  void setAgePenalty(double) {}
  void setInterMessageLowerBound(int, rclcpp::Duration) {}
  void setInterMessageLowerBound(rclcpp::Duration) {}
  void setMaxIntervalDuration(rclcpp::Duration most) {most_ = most.nanoseconds();}

  template<std::size_t I, class P>
  void add(const P & message, const typename Policy<Ms...>::Emit & emit)
  {
    auto & queue = std::get<I>(queues_);
    queue.push_back(message);
    if (queue.size() > queue_) {
      queue.pop_front();
    }
    while (complete()) {
      // The pivot is the newest of the first messages of the queues.
      const std::int64_t pivot = newest_front(std::index_sequence_for<Ms...>());
      forward(pivot, std::index_sequence_for<Ms...>());
      const std::int64_t span = newest_front(std::index_sequence_for<Ms...>()) -
        oldest_front(std::index_sequence_for<Ms...>());
      if (span <= most_) {
        const Set found = fronts(std::index_sequence_for<Ms...>());
        pop(std::index_sequence_for<Ms...>());
        emit(found);
      } else {
        drop_oldest(std::index_sequence_for<Ms...>());
      }
    }
  }

private:
  template<class M>
  static std::int64_t stamp(const std::shared_ptr<const M> & message)
  {
    return message_traits::TimeStamp<M>::value(*message).nanoseconds();
  }
  bool complete() const {return std::apply([](const auto & ... q) {return (... && !q.empty());}, queues_);}
  template<std::size_t ... Is>
  std::int64_t newest_front(std::index_sequence<Is...>) const
  {
    return std::max({stamp(std::get<Is>(queues_).front())...});
  }
  template<std::size_t ... Is>
  std::int64_t oldest_front(std::index_sequence<Is...>) const
  {
    return std::min({stamp(std::get<Is>(queues_).front())...});
  }
  template<std::size_t ... Is>
  Set fronts(std::index_sequence<Is...>) const {return Set(std::get<Is>(queues_).front()...);}
  template<std::size_t ... Is>
  void pop(std::index_sequence<Is...>) {(std::get<Is>(queues_).pop_front(), ...);}
  /// In each queue, passes over messages while the next one is nearer to the pivot.
  template<std::size_t ... Is>
  void forward(std::int64_t pivot, std::index_sequence<Is...>)
  {
    const auto pass = [pivot](auto & queue) {
        while (queue.size() > 1 && std::abs(stamp(queue[1]) - pivot) <= std::abs(stamp(queue[0]) - pivot)) {
          queue.pop_front();
        }
      };
    (pass(std::get<Is>(queues_)), ...);
  }
  template<std::size_t ... Is>
  void drop_oldest(std::index_sequence<Is...> all)
  {
    const std::int64_t oldest = oldest_front(all);
    bool dropped = false;
    const auto drop = [&](auto & queue) {
        if (!dropped && stamp(queue.front()) == oldest) {
          queue.pop_front();
          dropped = true;
        }
      };
    (drop(std::get<Is>(queues_)), ...);
  }

  std::size_t queue_;
  std::int64_t most_ = INT64_MAX;
  std::tuple<std::deque<std::shared_ptr<const Ms>>...> queues_;
};

/// Sets of messages whose stamps differ by at most an epsilon; a message without partners is dropped.
template<class ... Ms>
class ApproximateEpsilonTime : public Policy<Ms...>
{
public:
  using Set = typename Policy<Ms...>::Set;
  ApproximateEpsilonTime(std::uint32_t queue, const rclcpp::Duration & epsilon)
  : queue_(queue), epsilon_(epsilon.nanoseconds()) {}

  template<std::size_t I, class P>
  void add(const P & message, const typename Policy<Ms...>::Emit & emit)
  {
    auto & queue = std::get<I>(queues_);
    queue.push_back(message);
    if (queue_ > 0 && queue.size() > queue_) {
      queue.pop_front();
    }
    while (std::apply([](const auto & ... q) {return (... && !q.empty());}, queues_)) {
      const std::int64_t oldest = std::apply([](const auto & ... q) {return std::min({stamp(q.front())...});}, queues_);
      const std::int64_t newest = std::apply([](const auto & ... q) {return std::max({stamp(q.front())...});}, queues_);
      if (newest - oldest <= epsilon_) {
        const Set found = std::apply([](const auto & ... q) {return Set(q.front()...);}, queues_);
        std::apply([](auto & ... q) {(q.pop_front(), ...);}, queues_);
        emit(found);
      } else {
        std::apply([oldest](auto & ... q) {(drop(q, oldest), ...);}, queues_);
      }
    }
  }

private:
  template<class M>
  static std::int64_t stamp(const std::shared_ptr<const M> & message)
  {
    return message_traits::TimeStamp<M>::value(*message).nanoseconds();
  }
  template<class Q>
  static void drop(Q & queue, std::int64_t oldest)
  {
    if (stamp(queue.front()) == oldest) {
      queue.pop_front();
    }
  }

  std::uint32_t queue_;
  std::int64_t epsilon_;
  std::tuple<std::deque<std::shared_ptr<const Ms>>...> queues_;
};

}  // namespace sync_policies

template<class P>
class Synchronizer;

template<template<class ...> class P, class ... Ms>
class Synchronizer<P<Ms...>>: public P<Ms...>
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Synchronizer)
  using Policy = P<Ms...>;
  using Set = typename Policy::Set;

  explicit Synchronizer(const Policy & policy)
  : Policy(policy) {}
  template<class ... Fs>
  Synchronizer(const Policy & policy, Fs & ... filters)
  : Policy(policy) {connectInput(filters ...);}
  template<class F, class ... Fs, class = decltype(std::declval<F &>().getName())>
  explicit Synchronizer(F & first, Fs & ... filters)
  : Policy(10) {connectInput(first, filters ...);}

  template<class ... Fs>
  void connectInput(Fs & ... filters) {connect(std::index_sequence_for<Fs...>(), filters ...);}
  template<class F>
  Connection registerCallback(F callback)
  {
    callbacks_.push_back([callback](const Set & set) mutable {std::apply(callback, set);});
    return Connection();
  }
  template<class F, class T>
  Connection registerCallback(F method, T * object)
  {
    callbacks_.push_back(
      [method, object](const Set & set) {
        std::apply([&](const auto & ... one) {std::invoke(method, object, one ...);}, set);
      });
    return Connection();
  }
  void init() {}
  Policy * getPolicy() {return this;}
  void setName(const std::string & name) {name_ = name;}
  const std::string & getName() const {return name_;}
  template<int I, class M>
  void add(const std::shared_ptr<const M> & message) {put<I>(message);}

private:
  template<std::size_t ... Is, class ... Fs>
  void connect(std::index_sequence<Is...>, Fs & ... filters)
  {
    (filters.registerCallback(
      std::function<void(const std::shared_ptr<const std::tuple_element_t<Is, std::tuple<Ms...>>> &)>(
        [this](const auto & message) {this->template put<Is>(message);})), ...);
  }
  template<std::size_t I, class M>
  void put(const std::shared_ptr<const M> & message)
  {
    Policy::template add<I>(
      message, [this](const Set & set) {
        for (auto & callback : callbacks_) {
          callback(set);
        }
      });
  }

  std::vector<std::function<void(const Set &)>> callbacks_;
  std::string name_;
};

template<class ... Ms>
class TimeSynchronizer : public Synchronizer<sync_policies::ExactTime<Ms...>>
{
  using Base = Synchronizer<sync_policies::ExactTime<Ms...>>;

public:
  RCLCPP_SMART_PTR_DEFINITIONS(TimeSynchronizer)
  explicit TimeSynchronizer(std::uint32_t queue)
  : Base(sync_policies::ExactTime<Ms...>(queue)) {}
  template<class ... Fs>
  static std::tuple<Fs & ...> sitaf_tie(Fs & ... filters) {return std::tie(filters ...);}
  template<class F0, class F1>
  TimeSynchronizer(F0 & f0, F1 & f1, std::uint32_t queue)
  : TimeSynchronizer(queue) {this->connectInput(f0, f1);}
  template<class F0, class F1, class F2>
  TimeSynchronizer(F0 & f0, F1 & f1, F2 & f2, std::uint32_t queue)
  : TimeSynchronizer(queue) {this->connectInput(f0, f1, f2);}
  template<class F0, class F1, class F2, class F3>
  TimeSynchronizer(F0 & f0, F1 & f1, F2 & f2, F3 & f3, std::uint32_t queue)
  : TimeSynchronizer(queue) {this->connectInput(f0, f1, f2, f3);}
};

}  // namespace message_filters
