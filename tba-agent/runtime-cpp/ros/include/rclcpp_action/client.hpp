#pragma once

#include <future>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "rclcpp_action/types.hpp"

namespace rclcpp_action {

template<class A>
class Client;

template<class A>
class ClientGoalHandle
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(ClientGoalHandle)

  struct WrappedResult
  {
    GoalUUID goal_id{};
    ResultCode code = ResultCode::UNKNOWN;
    typename A::Result::SharedPtr result;
  };
  using Feedback = typename A::Feedback;
  using Result = typename A::Result;
  using FeedbackCallback = std::function<void (typename ClientGoalHandle::SharedPtr, const std::shared_ptr<const Feedback>)>;
  using ResultCallback = std::function<void (const WrappedResult &)>;

  explicit ClientGoalHandle(GoalInfo info)
  : info_(std::move(info)), future_(promise_.get_future().share()) {}

  const GoalUUID & get_goal_id() const {return info_.goal_id.uuid;}
  rclcpp::Time get_goal_stamp() const {return info_.stamp;}
  std::int8_t get_status() {return status_;}
  bool is_feedback_aware() {return static_cast<bool>(feedback_);}
  bool is_result_aware() {return asked_;}
  std::shared_future<WrappedResult> async_get_result()
  {
    if (!asked_) {
      throw exceptions::UnawareGoalHandleError();
    }
    return future_;
  }

private:
  friend class Client<A>;
  GoalInfo info_;
  std::int8_t status_ = GoalStatus::STATUS_ACCEPTED;
  bool asked_ = false;
  std::promise<WrappedResult> promise_;
  std::shared_future<WrappedResult> future_;
  FeedbackCallback feedback_;
  ResultCallback result_;
};

class ClientBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(ClientBase)
  virtual ~ClientBase() = default;
};

template<class A>
class Client : public ClientBase, public std::enable_shared_from_this<Client<A>>
{
  using Send = typename A::Impl::SendGoalService;
  using Get = typename A::Impl::GetResultService;
  using Cancel = action_msgs::srv::CancelGoal;

public:
  RCLCPP_SMART_PTR_DEFINITIONS(Client)
  using Goal = typename A::Goal;
  using Feedback = typename A::Feedback;
  using GoalHandle = ClientGoalHandle<A>;
  using WrappedResult = typename GoalHandle::WrappedResult;
  /// Also takes the callbacks of Humble, whose argument is a future.
  class GoalResponseCallback
  {
public:
    GoalResponseCallback() = default;
    GoalResponseCallback(std::nullptr_t) {}
    template<class F>
    GoalResponseCallback(F callback)
    {
      if constexpr (std::is_invocable_v<F &, typename GoalHandle::SharedPtr>) {
        call_ = [callback](typename GoalHandle::SharedPtr handle) mutable {callback(handle);};
      } else {
        call_ = [callback](typename GoalHandle::SharedPtr handle) mutable {
            std::promise<typename GoalHandle::SharedPtr> promise;
            promise.set_value(handle);
            callback(promise.get_future().share());
          };
      }
    }
    explicit operator bool() const {return static_cast<bool>(call_);}
    void operator()(const typename GoalHandle::SharedPtr & handle) const {call_(handle);}

private:
    std::function<void(typename GoalHandle::SharedPtr)> call_;
  };
  using FeedbackCallback = typename GoalHandle::FeedbackCallback;
  using ResultCallback = typename GoalHandle::ResultCallback;
  using CancelRequest = Cancel::Request;
  using CancelResponse = Cancel::Response;
  using CancelCallback = std::function<void (typename CancelResponse::SharedPtr)>;

  struct SendGoalOptions
  {
    GoalResponseCallback goal_response_callback;
    FeedbackCallback feedback_callback;
    ResultCallback result_callback;
  };

  void sitaf_begin(
    const rclcpp::node_interfaces::NodeCore::SharedPtr & node, const std::string & name,
    const rclcpp::CallbackGroup::SharedPtr & group)
  {
    const auto qos = rclcpp::ServicesQoS();
    send_ = rclcpp::create_client<Send>(node, name + "/_action/send_goal", qos, group);
    get_ = rclcpp::create_client<Get>(node, name + "/_action/get_result", qos, group);
    cancel_ = rclcpp::create_client<Cancel>(node, name + "/_action/cancel_goal", qos, group);
    rclcpp::SubscriptionOptions options;
    options.callback_group = group;
    std::weak_ptr<Client> weak = this->weak_from_this();
    feedback_ = rclcpp::create_subscription<typename A::Impl::FeedbackMessage>(
      node, name + "/_action/feedback", rclcpp::QoS(100),
      [weak](std::shared_ptr<const typename A::Impl::FeedbackMessage> message) {
        const auto self = weak.lock();
        if (self == nullptr) {
          return;
        }
        const auto found = self->goals_.find(message->goal_id.uuid);
        if (found != self->goals_.end()) {
          const auto handle = found->second;
          if (handle->feedback_) {
            handle->feedback_(handle, std::make_shared<const Feedback>(message->feedback));
          }
        }
      }, options);
  }

  bool action_server_is_ready() const {return send_->service_is_ready() && get_->service_is_ready();}
  template<class R = std::int64_t, class P = std::milli>
  bool wait_for_action_server(std::chrono::duration<R, P> time = std::chrono::duration<R, P>(-1))
  {
    return send_->wait_for_service(time);
  }

  std::shared_future<typename GoalHandle::SharedPtr> async_send_goal(
    const Goal & goal, const SendGoalOptions & options = SendGoalOptions())
  {
    auto promise = std::make_shared<std::promise<typename GoalHandle::SharedPtr>>();
    auto future = promise->get_future().share();
    auto request = std::make_shared<typename Send::Request>();
    request->goal_id.uuid = next_id();
    request->goal = goal;
    const GoalUUID id = request->goal_id.uuid;
    std::weak_ptr<Client> weak = this->weak_from_this();
    send_->async_send_request(
      request, [weak, promise, options, id](typename rclcpp::Client<Send>::SharedFuture response) {
        const auto self = weak.lock();
        typename GoalHandle::SharedPtr handle;
        if (self != nullptr && response.get()->accepted) {
          GoalInfo info;
          info.goal_id.uuid = id;
          info.stamp = response.get()->stamp;
          handle = std::make_shared<GoalHandle>(info);
          handle->feedback_ = options.feedback_callback;
          handle->result_ = options.result_callback;
          self->goals_[id] = handle;
        }
        promise->set_value(handle);
        if (options.goal_response_callback) {
          options.goal_response_callback(handle);
        }
        if (handle != nullptr && handle->result_) {
          self->ask_result(handle);
        }
      });
    return future;
  }

  std::shared_future<WrappedResult> async_get_result(
    typename GoalHandle::SharedPtr handle, ResultCallback callback = nullptr)
  {
    if (goals_.count(handle->get_goal_id()) == 0) {
      throw exceptions::UnknownGoalHandleError();
    }
    if (callback) {
      handle->result_ = callback;
    }
    ask_result(handle);
    return handle->future_;
  }

  std::shared_future<typename CancelResponse::SharedPtr> async_cancel_goal(
    typename GoalHandle::SharedPtr handle, CancelCallback callback = nullptr)
  {
    if (goals_.count(handle->get_goal_id()) == 0) {
      throw exceptions::UnknownGoalHandleError();
    }
    auto request = std::make_shared<CancelRequest>();
    request->goal_info.goal_id.uuid = handle->get_goal_id();
    return cancel(request, callback);
  }
  std::shared_future<typename CancelResponse::SharedPtr> async_cancel_all_goals(CancelCallback callback = nullptr)
  {
    return cancel(std::make_shared<CancelRequest>(), callback);
  }
  std::shared_future<typename CancelResponse::SharedPtr> async_cancel_goals_before(
    const rclcpp::Time & stamp, CancelCallback callback = nullptr)
  {
    auto request = std::make_shared<CancelRequest>();
    request->goal_info.stamp = stamp;
    return cancel(request, callback);
  }
  void stop_callbacks(typename GoalHandle::SharedPtr handle)
  {
    handle->feedback_ = nullptr;
    handle->result_ = nullptr;
  }

private:
  GoalUUID next_id()
  {
    GoalUUID id{};
    std::int64_t number = sitaf_ros::Graph::get().next_number();
    for (std::size_t i = id.size(); i-- > 8; number >>= 8) {
      id[i] = static_cast<std::uint8_t>(number);
    }
    id[0] = 1;  // differs from those of the test
    return id;
  }

  void ask_result(const typename GoalHandle::SharedPtr & handle)
  {
    if (handle->asked_) {
      return;
    }
    handle->asked_ = true;
    auto request = std::make_shared<typename Get::Request>();
    request->goal_id.uuid = handle->get_goal_id();
    std::weak_ptr<Client> weak = this->weak_from_this();
    get_->async_send_request(
      request, [weak, handle](typename rclcpp::Client<Get>::SharedFuture response) {
        WrappedResult result;
        result.goal_id = handle->get_goal_id();
        result.code = static_cast<ResultCode>(response.get()->status);
        result.result = std::make_shared<typename A::Result>(response.get()->result);
        handle->status_ = response.get()->status;
        handle->promise_.set_value(result);
        if (handle->result_) {
          handle->result_(result);
        }
        if (const auto self = weak.lock()) {
          self->goals_.erase(handle->get_goal_id());
        }
      });
  }

  std::shared_future<typename CancelResponse::SharedPtr> cancel(
    const std::shared_ptr<CancelRequest> & request, const CancelCallback & callback)
  {
    auto promise = std::make_shared<std::promise<typename CancelResponse::SharedPtr>>();
    auto future = promise->get_future().share();
    cancel_->async_send_request(
      request, [promise, callback](rclcpp::Client<Cancel>::SharedFuture response) {
        promise->set_value(response.get());
        if (callback) {
          callback(response.get());
        }
      });
    return future;
  }

  std::map<GoalUUID, typename GoalHandle::SharedPtr> goals_;
  typename rclcpp::Client<Send>::SharedPtr send_;
  typename rclcpp::Client<Get>::SharedPtr get_;
  rclcpp::Client<Cancel>::SharedPtr cancel_;
  std::shared_ptr<rclcpp::SubscriptionBase> feedback_;
};

template<class A, class N>
typename Client<A>::SharedPtr create_client(
  N && node, const std::string & name, rclcpp::CallbackGroup::SharedPtr group = nullptr)
{
  auto client = std::make_shared<Client<A>>();
  client->sitaf_begin(rclcpp::detail::core(std::forward<N>(node)), name, group);
  return client;
}

template<class A>
typename Client<A>::SharedPtr create_client(
  rclcpp::node_interfaces::NodeCore::SharedPtr node, rclcpp::node_interfaces::NodeCore::SharedPtr,
  rclcpp::node_interfaces::NodeCore::SharedPtr, rclcpp::node_interfaces::NodeCore::SharedPtr, const std::string & name,
  rclcpp::CallbackGroup::SharedPtr group = nullptr)
{
  return rclcpp_action::create_client<A>(node, name, group);
}

}  // namespace rclcpp_action
