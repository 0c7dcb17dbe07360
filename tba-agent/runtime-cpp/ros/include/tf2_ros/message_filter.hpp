// Holds messages until their transforms to the target frames are known.
#pragma once

#include <functional>
#include <list>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "message_filters/message_filters.hpp"
#include "tf2_ros/buffer.hpp"

namespace tf2_ros {

namespace filter_failure_reasons {

enum FilterFailureReason {Unknown, OutTheBack, EmptyFrameID, NoTransformFound, QueueFull, FilterFailureReasonCount};

}  // namespace filter_failure_reasons

using FilterFailureReason = filter_failure_reasons::FilterFailureReason;

class MessageFilterBase
{
public:
  using V_string = std::vector<std::string>;
  virtual ~MessageFilterBase() = default;
  virtual void clear() = 0;
  virtual void setTargetFrame(const std::string & frame) = 0;
  virtual void setTargetFrames(const V_string & frames) = 0;
  virtual void setTolerance(const rclcpp::Duration & tolerance) = 0;
};

template<class M, class B = Buffer>
class MessageFilter : public MessageFilterBase, public message_filters::SimpleFilter<M>
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(MessageFilter)
  using MConstPtr = std::shared_ptr<const M>;
  using MEvent = message_filters::MessageEvent<const M>;

  /// After the node, or its interfaces for logging and clock, may come the time to wait for a transform.
  template<class N, class ... More>
  MessageFilter(B & buffer, const std::string & frame, std::uint32_t queue, const N &, const More & ... more)
  : buffer_(buffer), queue_(queue)
  {
    (take(more), ...);
    setTargetFrame(frame);
  }
  template<class F, class N, class ... More>
  MessageFilter(F & filter, B & buffer, const std::string & frame, std::uint32_t queue, const N & node, const More & ... more)
  : MessageFilter(buffer, frame, queue, node, more ...) {connectInput(filter);}
  ~MessageFilter() override
  {
    input_.disconnect();
    *alive_ = false;
  }

  template<class F>
  void connectInput(F & filter)
  {
    input_.disconnect();
    input_ = filter.registerCallback([this](const MConstPtr & message) {add(message);});
  }
  void setTargetFrame(const std::string & frame) override {setTargetFrames({frame});}
  void setTargetFrames(const V_string & frames) override
  {
    frames_ = frames;
    for (auto & frame : frames_) {
      frame = !frame.empty() && frame.front() == '/' ? frame.substr(1) : frame;
    }
  }
  std::string getTargetFramesString()
  {
    std::string text;
    for (const auto & frame : frames_) {
      text += frame + " ";
    }
    return text;
  }
  void setTolerance(const rclcpp::Duration & tolerance) override {tolerance_ = tf2::Duration(tolerance.nanoseconds());}
  void clear() override {waiting_.clear();}
  void setQueueSize(std::uint32_t size) {queue_ = size;}
  std::uint32_t getQueueSize() {return queue_;}
  void registerFailureCallback(std::function<void(const MConstPtr &, FilterFailureReason)> callback)
  {
    failed_ = std::move(callback);
  }

  void add(const MEvent & event) {add(event.getMessage());}
  void add(const MConstPtr & message)
  {
    if (frames_.empty() || frames_.front().empty()) {
      return;
    }
    std::string source = message->header.frame_id;
    source = !source.empty() && source.front() == '/' ? source.substr(1) : source;
    if (source.empty()) {
      drop(message, filter_failure_reasons::EmptyFrameID);
      return;
    }
    const tf2::TimePoint time = fromMsg(message->header.stamp);
    std::vector<std::pair<std::string, tf2::TimePoint>> needed;
    for (const auto & frame : frames_) {
      needed.emplace_back(frame, time);
      if (tolerance_.count() > 0) {
        needed.emplace_back(frame, time + tolerance_);
      }
    }
    waiting_.push_back({++count_, message, needed.size()});
    const std::uint64_t id = count_;
    for (const auto & [frame, at] : needed) {
      buffer_.waitForTransform(
        frame, source, at, timeout_, [this, id, alive = alive_](const TransformStampedFuture & future) {
          if (*alive) {
            ready(id, future);
          }
        });
    }
    if (queue_ != 0 && waiting_.size() > queue_) {
      const MConstPtr oldest = waiting_.front().message;
      waiting_.pop_front();
      drop(oldest, filter_failure_reasons::QueueFull);
    }
  }

private:
  struct Waiting
  {
    std::uint64_t id;
    MConstPtr message;
    std::size_t missing;
  };

  template<class T>
  void take(const T & value)
  {
    if constexpr (std::is_convertible_v<T, tf2::Duration>) {
      timeout_ = value;
    }
  }
  void ready(std::uint64_t id, const TransformStampedFuture & future)
  {
    const auto found = std::find_if(waiting_.begin(), waiting_.end(), [id](const auto & one) {return one.id == id;});
    if (found == waiting_.end()) {
      return;
    }
    try {
      future.get();
    } catch (const tf2::TransformException &) {
      const MConstPtr message = found->message;
      waiting_.erase(found);
      drop(message, filter_failure_reasons::NoTransformFound);
      return;
    }
    if (--found->missing == 0) {
      const MConstPtr message = found->message;
      waiting_.erase(found);
      this->signalMessage(message);
    }
  }
  void drop(const MConstPtr & message, FilterFailureReason reason)
  {
    if (failed_) {
      failed_(message, reason);
    }
  }

  B & buffer_;
  std::vector<std::string> frames_;
  std::uint32_t queue_;
  tf2::Duration timeout_ = tf2::Duration::max(), tolerance_{0};
  std::list<Waiting> waiting_;
  std::uint64_t count_ = 0;
  std::function<void(const MConstPtr &, FilterFailureReason)> failed_;
  message_filters::Connection input_;
  std::shared_ptr<bool> alive_ = std::make_shared<bool>(true);
};

}  // namespace tf2_ros
