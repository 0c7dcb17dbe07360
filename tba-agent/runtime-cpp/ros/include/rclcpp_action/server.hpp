// Action servers: services and topics below NAME/_action, as https://design.ros2.org/articles/actions.html defines.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "rclcpp_action/types.hpp"

namespace rclcpp_action {

template<class A>
class Server;

template<class A>
class ServerGoalHandle
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(ServerGoalHandle)

  ServerGoalHandle(std::weak_ptr<Server<A>> server, GoalInfo info, std::shared_ptr<const typename A::Goal> goal)
  : info_(std::move(info)), goal_(std::move(goal)), server_(std::move(server)) {}

  bool is_canceling() const {return status_ == GoalStatus::STATUS_CANCELING;}
  bool is_active() const
  {
    return status_ == GoalStatus::STATUS_ACCEPTED || status_ == GoalStatus::STATUS_EXECUTING || is_canceling();
  }
  bool is_executing() const {return status_ == GoalStatus::STATUS_EXECUTING;}
  const std::shared_ptr<const typename A::Goal> get_goal() const {return goal_;}
  const GoalUUID & get_goal_id() const {return info_.goal_id.uuid;}
  void publish_feedback(std::shared_ptr<typename A::Feedback> feedback)
  {
    if (const auto server = server_.lock()) {
      server->publish_feedback(info_.goal_id.uuid, *feedback);
    }
  }
  void execute() {to(GoalStatus::STATUS_EXECUTING, status_ == GoalStatus::STATUS_ACCEPTED, "EXECUTE");}
  void succeed(typename A::Result::SharedPtr result)
  {
    to(GoalStatus::STATUS_SUCCEEDED, is_executing() || is_canceling(), "SUCCEED");
    finish(result);
  }
  void abort(typename A::Result::SharedPtr result)
  {
    to(GoalStatus::STATUS_ABORTED, is_executing() || is_canceling(), "ABORT");
    finish(result);
  }
  void canceled(typename A::Result::SharedPtr result)
  {
    to(GoalStatus::STATUS_CANCELED, is_canceling(), "CANCELED");
    finish(result);
  }
  void sitaf_cancel() {status_ = GoalStatus::STATUS_CANCELING;}
  std::int8_t sitaf_status() const {return status_;}
  const GoalInfo & sitaf_info() const {return info_;}

private:
  void to(std::int8_t status, bool allowed, const std::string & event)
  {
    if (!allowed) {
      throw rclcpp::exceptions::RCLError(
              "goal_handle attempted invalid transition from state " + std::to_string(status_) + " with event " + event);
    }
    status_ = status;
    if (const auto server = server_.lock()) {
      server->publish_status();
    }
  }
  void finish(const typename A::Result::SharedPtr & result)
  {
    if (const auto server = server_.lock()) {
      server->finish(info_.goal_id.uuid, status_, *result);
    }
  }

  GoalInfo info_;
  std::shared_ptr<const typename A::Goal> goal_;
  std::weak_ptr<Server<A>> server_;
  std::int8_t status_ = GoalStatus::STATUS_ACCEPTED;
};

class ServerBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(ServerBase)
  virtual ~ServerBase() = default;
};

template<class A>
class Server : public ServerBase, public std::enable_shared_from_this<Server<A>>
{
  using Send = typename A::Impl::SendGoalService;
  using Get = typename A::Impl::GetResultService;
  using Cancel = action_msgs::srv::CancelGoal;

public:
  RCLCPP_SMART_PTR_DEFINITIONS(Server)
  using Handle = ServerGoalHandle<A>;
  using GoalCallback = std::function<GoalResponse(const GoalUUID &, std::shared_ptr<const typename A::Goal>)>;
  using CancelCallback = std::function<CancelResponse(std::shared_ptr<Handle>)>;
  using AcceptedCallback = std::function<void (std::shared_ptr<Handle>)>;

  Server(GoalCallback goal, CancelCallback cancel, AcceptedCallback accepted)
  : goal_(std::move(goal)), cancel_(std::move(cancel)), accepted_(std::move(accepted)) {}

  void sitaf_begin(
    const rclcpp::node_interfaces::NodeCore::SharedPtr & node, const std::string & name,
    const rclcpp::CallbackGroup::SharedPtr & group)
  {
    node_ = node.get();
    feedback_ = rclcpp::create_publisher<typename A::Impl::FeedbackMessage>(node, name + "/_action/feedback", 10);
    status_ = rclcpp::create_publisher<action_msgs::msg::GoalStatusArray>(
      node, name + "/_action/status", rclcpp::QoS(1).transient_local());
    const auto qos = rclcpp::ServicesQoS();
    std::weak_ptr<Server> weak = this->weak_from_this();
    services_.push_back(rclcpp::create_service<Send>(
        node, name + "/_action/send_goal",
        [weak](
          std::shared_ptr<rclcpp::Service<Send>> service, std::shared_ptr<rmw_request_id_t> id,
          typename Send::Request::SharedPtr request) {
          if (const auto self = weak.lock()) {
            self->on_goal(*service, *id, request);
          }
        }, qos, group));
    services_.push_back(rclcpp::create_service<Get>(
        node, name + "/_action/get_result",
        [weak](
          std::shared_ptr<rclcpp::Service<Get>> service, std::shared_ptr<rmw_request_id_t> id,
          typename Get::Request::SharedPtr request) {
          if (const auto self = weak.lock()) {
            self->on_result(service, *id, request->goal_id.uuid);
          }
        }, qos, group));
    services_.push_back(rclcpp::create_service<Cancel>(
        node, name + "/_action/cancel_goal",
        [weak](Cancel::Request::SharedPtr request, Cancel::Response::SharedPtr response) {
          if (const auto self = weak.lock()) {
            self->on_cancel(*request, *response);
          }
        }, qos, group));
  }

  void publish_feedback(const GoalUUID & id, const typename A::Feedback & feedback)
  {
    typename A::Impl::FeedbackMessage message;
    message.goal_id.uuid = id;
    message.feedback = feedback;
    feedback_->publish(message);
  }
  void publish_status()
  {
    action_msgs::msg::GoalStatusArray message;
    for (const auto & [id, goal] : goals_) {
      action_msgs::msg::GoalStatus status;
      status.goal_info = goal.handle->sitaf_info();
      status.status = goal.handle->sitaf_status();
      message.status_list.push_back(status);
    }
    status_->publish(message);
  }
  void finish(const GoalUUID & id, std::int8_t status, const typename A::Result & result)
  {
    Known & goal = goals_.at(id);
    goal.response.status = status;
    goal.response.result = result;
    goal.done = true;
    const auto waiting = std::move(goal.waiting);
    for (auto & [service, request] : waiting) {
      auto copy = request;
      service->send_response(copy, goal.response);
    }
  }

private:
  struct Known
  {
    std::shared_ptr<Handle> handle;
    bool done = false;
    typename Get::Response response{};
    std::vector<std::pair<std::shared_ptr<rclcpp::Service<Get>>, rmw_request_id_t>> waiting{};
  };

  void on_goal(rclcpp::Service<Send> & service, rmw_request_id_t & id, const typename Send::Request::SharedPtr & request)
  {
    const GoalUUID uuid = request->goal_id.uuid;
    auto goal = std::make_shared<const typename A::Goal>(request->goal);
    const GoalResponse answer = goal_(uuid, goal);
    typename Send::Response response;
    response.accepted = answer != GoalResponse::REJECT;
    response.stamp = node_->now();
    std::shared_ptr<Handle> handle;
    if (response.accepted) {
      GoalInfo info;
      info.goal_id.uuid = uuid;
      info.stamp = response.stamp;
      handle = std::make_shared<Handle>(this->weak_from_this(), info, goal);
      goals_[uuid].handle = handle;
    }
    service.send_response(id, response);
    if (handle != nullptr) {
      if (answer == GoalResponse::ACCEPT_AND_EXECUTE) {
        handle->execute();
      } else {
        publish_status();
      }
      accepted_(handle);
    }
  }

  void on_result(const std::shared_ptr<rclcpp::Service<Get>> & service, rmw_request_id_t & id, const GoalUUID & uuid)
  {
    const auto found = goals_.find(uuid);
    if (found == goals_.end()) {
      typename Get::Response response;
      response.status = GoalStatus::STATUS_UNKNOWN;
      service->send_response(id, response);
    } else if (found->second.done) {
      service->send_response(id, found->second.response);
    } else {
      found->second.waiting.emplace_back(service, id);
    }
  }

  void on_cancel(const Cancel::Request & request, Cancel::Response & response)
  {
    const GoalUUID & wanted = request.goal_info.goal_id.uuid;
    const bool all = wanted == GoalUUID{};
    bool known = false;
    for (auto & [id, goal] : goals_) {
      if (!all && id != wanted) {
        continue;
      }
      known = true;
      if (!goal.handle->is_active()) {
        response.return_code = Cancel::Response::ERROR_GOAL_TERMINATED;
        continue;
      }
      if (cancel_(goal.handle) == CancelResponse::ACCEPT) {
        goal.handle->sitaf_cancel();
        response.goals_canceling.push_back(goal.handle->sitaf_info());
      }
    }
    if (!response.goals_canceling.empty()) {
      response.return_code = Cancel::Response::ERROR_NONE;
      publish_status();
    } else if (!known) {
      response.return_code = Cancel::Response::ERROR_UNKNOWN_GOAL_ID;
    } else if (response.return_code == Cancel::Response::ERROR_NONE) {
      response.return_code = Cancel::Response::ERROR_REJECTED;
    }
  }

  rclcpp::node_interfaces::NodeCore * node_ = nullptr;
  GoalCallback goal_;
  CancelCallback cancel_;
  AcceptedCallback accepted_;
  std::map<GoalUUID, Known> goals_;
  std::shared_ptr<rclcpp::Publisher<typename A::Impl::FeedbackMessage>> feedback_;
  std::shared_ptr<rclcpp::Publisher<action_msgs::msg::GoalStatusArray>> status_;
  std::vector<std::shared_ptr<void>> services_;
};

struct ServerOptions {};
inline ServerOptions rcl_action_server_get_default_options() {return {};}

template<class A, class N>
typename Server<A>::SharedPtr create_server(
  N && node, const std::string & name, typename Server<A>::GoalCallback goal, typename Server<A>::CancelCallback cancel,
  typename Server<A>::AcceptedCallback accepted, const ServerOptions & = {},
  rclcpp::CallbackGroup::SharedPtr group = nullptr)
{
  auto server = std::make_shared<Server<A>>(std::move(goal), std::move(cancel), std::move(accepted));
  server->sitaf_begin(rclcpp::detail::core(std::forward<N>(node)), name, group);
  return server;
}

template<class A>
typename Server<A>::SharedPtr create_server(
  rclcpp::node_interfaces::NodeCore::SharedPtr node, rclcpp::node_interfaces::NodeCore::SharedPtr,
  rclcpp::node_interfaces::NodeCore::SharedPtr, rclcpp::node_interfaces::NodeCore::SharedPtr, const std::string & name,
  typename Server<A>::GoalCallback goal, typename Server<A>::CancelCallback cancel,
  typename Server<A>::AcceptedCallback accepted, const ServerOptions & = {},
  rclcpp::CallbackGroup::SharedPtr group = nullptr)
{
  return rclcpp_action::create_server<A>(node, name, std::move(goal), std::move(cancel), std::move(accepted), {}, group);
}

}  // namespace rclcpp_action

// As in C, where they come from.
using rcl_action_server_options_t = rclcpp_action::ServerOptions;
using rclcpp_action::rcl_action_server_get_default_options;
