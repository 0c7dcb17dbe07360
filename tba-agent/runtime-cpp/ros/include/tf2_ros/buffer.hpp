#pragma once

#include <algorithm>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "rclcpp/rclcpp.hpp"
#include "tf2/convert.hpp"
#include "tf2_msgs/msg/tf_message.hpp"

namespace tf2_ros {

inline tf2::TimePoint fromMsg(const builtin_interfaces::msg::Time & time) {return tf2::sitaf_time_point(time);}
inline tf2::TimePoint fromRclcpp(const rclcpp::Time & time)
{
  return tf2::TimePoint(std::chrono::nanoseconds(time.nanoseconds()));
}
inline tf2::Duration fromRclcpp(const rclcpp::Duration & time) {return tf2::Duration(time.nanoseconds());}
inline tf2::Duration fromMsg(const builtin_interfaces::msg::Duration & time)
{
  return tf2::Duration(std::int64_t{time.sec} * 1'000'000'000 + time.nanosec);
}
inline rclcpp::Time toRclcpp(const tf2::TimePoint & time) {return rclcpp::Time(time.time_since_epoch().count(), RCL_ROS_TIME);}
inline rclcpp::Duration toRclcpp(const tf2::Duration & time) {return rclcpp::Duration(time);}
inline builtin_interfaces::msg::Time toMsg(const tf2::TimePoint & time) {return toRclcpp(time);}
inline builtin_interfaces::msg::Duration toMsg(const tf2::Duration & time) {return toRclcpp(time);}

inline double timeToSec(const builtin_interfaces::msg::Time & time) {return tf2::timeToSec(fromMsg(time));}

class CreateTimerInterfaceException : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Makes the timers that end a wait for a transform.
class CreateTimerInterface
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(CreateTimerInterface)
  virtual ~CreateTimerInterface() = default;
  virtual rclcpp::TimerBase::SharedPtr sitaf_timer(
    rclcpp::Clock::SharedPtr clock, const tf2::Duration & period, std::function<void()> callback) = 0;
};
class CreateTimerROS : public CreateTimerInterface
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(CreateTimerROS)
  using NodeInterface = rclcpp::node_interfaces::NodeCore::SharedPtr;
  CreateTimerROS(NodeInterface base, NodeInterface, rclcpp::CallbackGroup::SharedPtr group = nullptr)
  : node_(base), group_(std::move(group)) {}
  rclcpp::TimerBase::SharedPtr sitaf_timer(
    rclcpp::Clock::SharedPtr clock, const tf2::Duration & period, std::function<void()> callback) override
  {
    const auto node = node_.lock();
    return node == nullptr ? nullptr :
           rclcpp::create_timer(node, clock, rclcpp::Duration(period), std::move(callback), group_);
  }

private:
  rclcpp::node_interfaces::NodeCore::WeakPtr node_;
  rclcpp::CallbackGroup::SharedPtr group_;
};

using TransformStampedFuture = std::shared_future<geometry_msgs::msg::TransformStamped>;
using TransformReadyCallback = std::function<void (const TransformStampedFuture &)>;

class BufferInterface
{
public:
  virtual ~BufferInterface() = default;
};
class AsyncBufferInterface {};

class Buffer : public BufferInterface, public AsyncBufferInterface, public tf2::BufferCore
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Buffer)
  using tf2::BufferCore::canTransform;
  using tf2::BufferCore::lookupTransform;
  using Message = geometry_msgs::msg::TransformStamped;

  template<class ... More>
  explicit Buffer(
    rclcpp::Clock::SharedPtr clock, tf2::Duration cache = tf2::BUFFER_CORE_DEFAULT_CACHE_TIME, const More & ...)
  : BufferCore(cache), clock_(std::move(clock)) {}

  Message lookupTransform(
    const std::string & target, const std::string & source, const tf2::TimePoint & time, tf2::Duration timeout) const
  {
    wait([&] {return canTransform(target, source, time);}, timeout);
    return BufferCore::lookupTransform(target, source, time);
  }
  Message lookupTransform(
    const std::string & target, const std::string & source, const rclcpp::Time & time,
    rclcpp::Duration timeout = rclcpp::Duration(0, 0)) const
  {
    return lookupTransform(target, source, fromRclcpp(time), fromRclcpp(timeout));
  }
  Message lookupTransform(
    const std::string & target, const rclcpp::Time & target_time, const std::string & source,
    const rclcpp::Time & source_time, const std::string & fixed,
    rclcpp::Duration timeout = rclcpp::Duration(0, 0)) const
  {
    const auto a = fromRclcpp(target_time), b = fromRclcpp(source_time);
    wait([&] {return canTransform(target, a, source, b, fixed);}, fromRclcpp(timeout));
    return BufferCore::lookupTransform(target, a, source, b, fixed);
  }
  bool canTransform(
    const std::string & target, const std::string & source, const tf2::TimePoint & time, tf2::Duration timeout,
    std::string * why = nullptr) const
  {
    wait([&] {return canTransform(target, source, time);}, timeout);
    return BufferCore::canTransform(target, source, time, why);
  }
  bool canTransform(
    const std::string & target, const std::string & source, const rclcpp::Time & time,
    rclcpp::Duration timeout = rclcpp::Duration(0, 0), std::string * why = nullptr) const
  {
    return canTransform(target, source, fromRclcpp(time), fromRclcpp(timeout), why);
  }
  TransformStampedFuture waitForTransform(
    const std::string & target, const std::string & source, const tf2::TimePoint & time, const tf2::Duration & timeout,
    TransformReadyCallback callback)
  {
    if (timers_ == nullptr) {
      throw CreateTimerInterfaceException("timer interface not set before call to waitForTransform");
    }
    auto promise = std::make_shared<std::promise<Message>>();
    TransformStampedFuture future = promise->get_future().share();
    auto waiting = std::make_shared<Waiting>();
    waiting->arrived = [this, target, source, time, promise, future, callback] {
        if (!canTransform(target, source, time)) {
          return false;
        }
        promise->set_value(BufferCore::lookupTransform(target, source, time));
        callback(future);
        return true;
      };
    if (waiting->arrived()) {
      return future;
    }
    waiting_.push_back(waiting);
    if (timeout < LONGEST_TIMEOUT) {
      std::weak_ptr<Waiting> weak = waiting;
      const std::string text = "Timed out waiting for transform from " + source + " to " + target;
      waiting->timer = timers_->sitaf_timer(clock_, timeout, [this, weak, promise, future, callback, text] {
            const auto late = waiting_.end();
            const auto found = std::find(waiting_.begin(), late, weak.lock());
            if (found == late) {
              return;
            }
            const auto kept = *found;
            kept->timer->cancel();
            waiting_.erase(found);
            promise->set_exception(std::make_exception_ptr(tf2::TimeoutException(text)));
            callback(future);
          });
    }
    return future;
  }
  TransformStampedFuture waitForTransform(
    const std::string & target, const std::string & source, const rclcpp::Time & time, const rclcpp::Duration & timeout,
    TransformReadyCallback callback)
  {
    return waitForTransform(target, source, fromRclcpp(time), fromRclcpp(timeout), callback);
  }

  template<class T>
  T & transform(
    const T & in, T & out, const std::string & target, tf2::Duration timeout = tf2::durationFromSec(0)) const
  {
    tf2::doTransform(in, out, lookupTransform(target, tf2::getFrameId(in), tf2::getTimestamp(in), timeout));
    return out;
  }
  template<class T>
  T transform(const T & in, const std::string & target, tf2::Duration timeout = tf2::durationFromSec(0)) const
  {
    T out;
    return transform(in, out, target, timeout);
  }

  void setUsingDedicatedThread(bool) {}
  bool isUsingDedicatedThread() const {return true;}
  void setCreateTimerInterface(CreateTimerInterface::SharedPtr timers) {timers_ = std::move(timers);}
  rclcpp::Clock::SharedPtr getClock() const {return clock_;}

protected:
  void changed() override
  {
    for (const auto & one : std::vector<std::shared_ptr<Waiting>>(waiting_)) {
      // A callback may have ended another wait.
      const auto found = std::find(waiting_.begin(), waiting_.end(), one);
      if (found != waiting_.end() && can_end(*one)) {
        waiting_.erase(std::find(waiting_.begin(), waiting_.end(), one));
      }
    }
    sitaf_ros::kernel::wake(this);
  }

private:
  struct Waiting
  {
    /// Ends the wait if the transform is there.
    std::function<bool()> arrived;
    rclcpp::TimerBase::SharedPtr timer;
  };
  // Timers cannot have the longest duration there is; a century is as good.
  static constexpr tf2::Duration LONGEST_TIMEOUT = std::chrono::hours(24 * 365 * 100);

  static bool can_end(Waiting & waiting)
  {
    const bool ends = waiting.arrived();
    if (ends && waiting.timer != nullptr) {
      waiting.timer->cancel();
    }
    return ends;
  }
  template<class F>
  void wait(F is_there, tf2::Duration timeout) const
  {
    const sitaf_ros::Nanos until = sitaf_ros::kernel::now() + timeout.count();
    while (!is_there() && sitaf_ros::kernel::now() < until && !sitaf_ros::kernel::ending() && rclcpp::ok()) {
      sitaf_ros::kernel::wait(this, until, true);
    }
  }

  rclcpp::Clock::SharedPtr clock_;
  CreateTimerInterface::SharedPtr timers_;
  std::vector<std::shared_ptr<Waiting>> waiting_;
};

class TransformListener
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(TransformListener)

  explicit TransformListener(tf2::BufferCore & buffer, bool = true, bool static_only = false)
  : own_(std::make_shared<rclcpp::Node>("transform_listener_impl"))
  {
    begin(buffer, own_->get_node_base_interface(), static_only);
  }
  template<class N, class ... More, class = decltype(rclcpp::detail::core(std::declval<N>()))>
  TransformListener(tf2::BufferCore & buffer, N && node, const More & ...)
  {
    begin(buffer, rclcpp::detail::core(std::forward<N>(node)), false);
  }
  virtual ~TransformListener()
  {
    executor_->cancel();
    subscriptions_.clear();
  }

private:
  // In ROS a thread of its own takes the transforms, also while a callback of the node waits for them.
  void begin(tf2::BufferCore & buffer, const rclcpp::node_interfaces::NodeCore::SharedPtr & node, bool static_only)
  {
    group_ = node->create_callback_group(rclcpp::CallbackGroupType::MutuallyExclusive, false);
    rclcpp::SubscriptionOptions options;
    options.callback_group = group_;
    const auto add = [&](const std::string & topic, const rclcpp::QoS & qos, bool is_static) {
        subscriptions_.push_back(rclcpp::create_subscription<tf2_msgs::msg::TFMessage>(
            node, topic, qos, [&buffer, is_static](const tf2_msgs::msg::TFMessage & message) {
              for (const auto & transform : message.transforms) {
                buffer.setTransform(transform, "Authority undetectable", is_static);
              }
            }, options));
      };
    if (!static_only) {
      add("/tf", rclcpp::QoS(100), false);
    }
    add("/tf_static", rclcpp::QoS(100).transient_local(), true);
    executor_ = std::make_shared<rclcpp::executors::SingleThreadedExecutor>();
    executor_->add_callback_group(group_, node);
    auto executor = executor_;
    sitaf_ros::kernel::start("the transform listener", [executor] {executor->spin();});
  }

  std::shared_ptr<rclcpp::Node> own_;
  rclcpp::CallbackGroup::SharedPtr group_;
  std::vector<std::shared_ptr<rclcpp::SubscriptionBase>> subscriptions_;
  std::shared_ptr<rclcpp::executors::SingleThreadedExecutor> executor_;
};

class TransformBroadcaster
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(TransformBroadcaster)
  using Message = geometry_msgs::msg::TransformStamped;

  template<class N, class ... More>
  explicit TransformBroadcaster(N && node, const More & ...)
  : publisher_(rclcpp::create_publisher<tf2_msgs::msg::TFMessage>(std::forward<N>(node), "/tf", rclcpp::QoS(100))) {}
  void sendTransform(const Message & transform) {sendTransform(std::vector<Message>{transform});}
  void sendTransform(const std::vector<Message> & transforms)
  {
    tf2_msgs::msg::TFMessage message;
    message.transforms = transforms;
    publisher_->publish(message);
  }

private:
  std::shared_ptr<rclcpp::Publisher<tf2_msgs::msg::TFMessage>> publisher_;
};

class StaticTransformBroadcaster
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(StaticTransformBroadcaster)
  using Message = geometry_msgs::msg::TransformStamped;

  template<class N, class ... More>
  explicit StaticTransformBroadcaster(N && node, const More & ...)
  : publisher_(rclcpp::create_publisher<tf2_msgs::msg::TFMessage>(
        std::forward<N>(node), "/tf_static", rclcpp::QoS(1).transient_local())) {}
  void sendTransform(const Message & transform) {sendTransform(std::vector<Message>{transform});}
  void sendTransform(const std::vector<Message> & transforms)
  {
    for (const auto & transform : transforms) {
      const auto same = std::find_if(
        all_.transforms.begin(), all_.transforms.end(),
        [&](const Message & other) {return other.child_frame_id == transform.child_frame_id;});
      if (same == all_.transforms.end()) {
        all_.transforms.push_back(transform);
      } else {
        *same = transform;
      }
    }
    publisher_->publish(all_);
  }

private:
  std::shared_ptr<rclcpp::Publisher<tf2_msgs::msg::TFMessage>> publisher_;
  tf2_msgs::msg::TFMessage all_;
};

}  // namespace tf2_ros
