// The state machine of https://design.ros2.org/articles/node_lifecycle.html.
#include "rclcpp_lifecycle/lifecycle_node.hpp"

#include <array>

#include "lifecycle_msgs/srv/change_state.hpp"
#include "lifecycle_msgs/srv/get_available_states.hpp"
#include "lifecycle_msgs/srv/get_available_transitions.hpp"
#include "lifecycle_msgs/srv/get_state.hpp"

namespace rclcpp_lifecycle {

namespace {

using lifecycle_msgs::msg::Transition;
using Ids = lifecycle_msgs::msg::State;

const State & state_of(std::uint8_t id)
{
  static const std::map<std::uint8_t, State> states = [] {
      std::map<std::uint8_t, State> made;
      for (const auto & [number, label] : std::vector<std::pair<std::uint8_t, const char *>>{
          {Ids::PRIMARY_STATE_UNKNOWN, "unknown"}, {Ids::PRIMARY_STATE_UNCONFIGURED, "unconfigured"},
          {Ids::PRIMARY_STATE_INACTIVE, "inactive"}, {Ids::PRIMARY_STATE_ACTIVE, "active"},
          {Ids::PRIMARY_STATE_FINALIZED, "finalized"}, {Ids::TRANSITION_STATE_CONFIGURING, "configuring"},
          {Ids::TRANSITION_STATE_CLEANINGUP, "cleaningup"}, {Ids::TRANSITION_STATE_SHUTTINGDOWN, "shuttingdown"},
          {Ids::TRANSITION_STATE_ACTIVATING, "activating"}, {Ids::TRANSITION_STATE_DEACTIVATING, "deactivating"},
          {Ids::TRANSITION_STATE_ERRORPROCESSING, "errorprocessing"}})
      {
        made.emplace(number, State(number, label));
      }
      return made;
    }();
  return states.at(id);
}

struct Step
{
  std::uint8_t transition;
  const char * label;
  const char * callback;
  std::uint8_t from, through, to;
};

constexpr std::array<Step, 7> STEPS{{
  {Transition::TRANSITION_CONFIGURE, "configure", "on_configure", Ids::PRIMARY_STATE_UNCONFIGURED,
    Ids::TRANSITION_STATE_CONFIGURING, Ids::PRIMARY_STATE_INACTIVE},
  {Transition::TRANSITION_CLEANUP, "cleanup", "on_cleanup", Ids::PRIMARY_STATE_INACTIVE,
    Ids::TRANSITION_STATE_CLEANINGUP, Ids::PRIMARY_STATE_UNCONFIGURED},
  {Transition::TRANSITION_ACTIVATE, "activate", "on_activate", Ids::PRIMARY_STATE_INACTIVE,
    Ids::TRANSITION_STATE_ACTIVATING, Ids::PRIMARY_STATE_ACTIVE},
  {Transition::TRANSITION_DEACTIVATE, "deactivate", "on_deactivate", Ids::PRIMARY_STATE_ACTIVE,
    Ids::TRANSITION_STATE_DEACTIVATING, Ids::PRIMARY_STATE_INACTIVE},
  {Transition::TRANSITION_UNCONFIGURED_SHUTDOWN, "shutdown", "on_shutdown", Ids::PRIMARY_STATE_UNCONFIGURED,
    Ids::TRANSITION_STATE_SHUTTINGDOWN, Ids::PRIMARY_STATE_FINALIZED},
  {Transition::TRANSITION_INACTIVE_SHUTDOWN, "shutdown", "on_shutdown", Ids::PRIMARY_STATE_INACTIVE,
    Ids::TRANSITION_STATE_SHUTTINGDOWN, Ids::PRIMARY_STATE_FINALIZED},
  {Transition::TRANSITION_ACTIVE_SHUTDOWN, "shutdown", "on_shutdown", Ids::PRIMARY_STATE_ACTIVE,
    Ids::TRANSITION_STATE_SHUTTINGDOWN, Ids::PRIMARY_STATE_FINALIZED},
}};

const Step * step(std::uint8_t state, std::uint8_t transition, const std::string & label)
{
  for (const Step & one : STEPS) {
    if (one.from == state && (label.empty() ? one.transition == transition : label == one.label)) {
      return &one;
    }
  }
  return nullptr;
}

rclcpp_lifecycle::Transition transition_of(const Step & one)
{
  return rclcpp_lifecycle::Transition(one.transition, one.label, state_of(one.from), state_of(one.to));
}

lifecycle_msgs::msg::State message_of(const State & state)
{
  lifecycle_msgs::msg::State message;
  message.id = state.id();
  message.label = state.label();
  return message;
}

lifecycle_msgs::msg::TransitionDescription described(const Step & one)
{
  lifecycle_msgs::msg::TransitionDescription message;
  message.transition.id = one.transition;
  message.transition.label = one.label;
  message.start_state = message_of(state_of(one.from));
  message.goal_state = message_of(state_of(one.to));
  return message;
}

}  // namespace

LifecycleNode::LifecycleNode(
  const std::string & name, const std::string & name_space, const rclcpp::NodeOptions & options, bool services)
: NodeApi(name, name_space, options), state_(Ids::PRIMARY_STATE_UNCONFIGURED)
{
  event_ = rclcpp::create_publisher<lifecycle_msgs::msg::TransitionEvent>(
    core_, "~/transition_event", rclcpp::QoS(10));
  if (services) {
    make_services();
  }
}

LifecycleNode::~LifecycleNode() = default;

const State & LifecycleNode::get_current_state() const {return state_of(state_);}

std::vector<State> LifecycleNode::get_available_states() const
{
  std::vector<State> states;
  for (std::uint8_t id = 0; id <= Ids::PRIMARY_STATE_FINALIZED; ++id) {
    states.push_back(state_of(id));
  }
  for (std::uint8_t id = Ids::TRANSITION_STATE_CONFIGURING; id <= Ids::TRANSITION_STATE_ERRORPROCESSING; ++id) {
    states.push_back(state_of(id));
  }
  return states;
}

std::vector<rclcpp_lifecycle::Transition> LifecycleNode::get_available_transitions() const
{
  std::vector<rclcpp_lifecycle::Transition> found;
  for (const Step & one : STEPS) {
    if (one.from == state_) {
      found.push_back(transition_of(one));
    }
  }
  return found;
}

std::vector<rclcpp_lifecycle::Transition> LifecycleNode::get_transition_graph() const
{
  std::vector<rclcpp_lifecycle::Transition> found;
  for (const Step & one : STEPS) {
    found.push_back(transition_of(one));
  }
  return found;
}

void LifecycleNode::enter(std::uint8_t state, std::uint8_t transition)
{
  lifecycle_msgs::msg::TransitionEvent event;
  event.timestamp = static_cast<std::uint64_t>(now().nanoseconds());
  event.transition.id = transition;
  event.start_state = message_of(state_of(state_));
  event.goal_state = message_of(state_of(state));
  state_ = state;
  event_->publish(event);
}

LifecycleNode::CallbackReturn LifecycleNode::call(const std::string & name, const State & previous)
{
  try {
    const auto registered = registered_.find(name);
    if (registered != registered_.end()) {
      return registered->second(previous);
    }
    return name == "on_configure" ? on_configure(previous) : name == "on_cleanup" ? on_cleanup(previous) :
           name == "on_activate" ? on_activate(previous) : name == "on_deactivate" ? on_deactivate(previous) :
           name == "on_shutdown" ? on_shutdown(previous) : on_error(previous);
  } catch (const std::exception & e) {
    RCLCPP_ERROR(get_logger(), "Caught exception in callback for transition %s: %s", name.c_str(), e.what());
    return CallbackReturn::ERROR;
  }
}

const State & LifecycleNode::trigger_transition(std::uint8_t id)
{
  CallbackReturn code;
  return trigger_transition(id, code);
}

const State & LifecycleNode::trigger_transition(std::uint8_t id, CallbackReturn & code)
{
  const Step * chosen = step(state_, id, "");
  code = CallbackReturn::ERROR;
  if (chosen == nullptr) {
    RCLCPP_ERROR(
      get_logger(), "Unable to start transition %u from current state %s.", id, get_current_state().label().c_str());
    return get_current_state();
  }
  const State & previous = state_of(state_);
  enter(chosen->through, id);
  code = call(chosen->callback, previous);
  if (code == CallbackReturn::SUCCESS) {
    enter(chosen->to, id);
  } else if (code == CallbackReturn::FAILURE) {
    enter(chosen->to == Ids::PRIMARY_STATE_FINALIZED ? Ids::PRIMARY_STATE_FINALIZED : chosen->from, id);
  } else {
    enter(Ids::TRANSITION_STATE_ERRORPROCESSING, id);
    const CallbackReturn handled = call("on_error", state_of(chosen->through));
    enter(
      handled == CallbackReturn::SUCCESS ? Ids::PRIMARY_STATE_UNCONFIGURED : Ids::PRIMARY_STATE_FINALIZED, id);
  }
  return get_current_state();
}

#define SITAF_TRANSITION(name) \
  const State & LifecycleNode::name() \
  { \
    CallbackReturn code; \
    return name(code); \
  } \
  const State & LifecycleNode::name(CallbackReturn & code) \
  { \
    const Step * chosen = step(state_, 0, #name); \
    return trigger_transition(chosen == nullptr ? 255 : chosen->transition, code); \
  }
SITAF_TRANSITION(configure)
SITAF_TRANSITION(cleanup)
SITAF_TRANSITION(activate)
SITAF_TRANSITION(deactivate)
SITAF_TRANSITION(shutdown)

LifecycleNode::CallbackReturn LifecycleNode::on_activate(const State &)
{
  for (const auto & weak : entities_) {
    if (const auto entity = weak.lock()) {
      entity->on_activate();
    }
  }
  return CallbackReturn::SUCCESS;
}

LifecycleNode::CallbackReturn LifecycleNode::on_deactivate(const State &)
{
  for (const auto & weak : entities_) {
    if (const auto entity = weak.lock()) {
      entity->on_deactivate();
    }
  }
  return CallbackReturn::SUCCESS;
}

void LifecycleNode::make_services()
{
  using namespace lifecycle_msgs::srv;  // NOLINT
  parts_.push_back(rclcpp::create_service<ChangeState>(
      core_, "~/change_state",
      [this](ChangeState::Request::SharedPtr request, ChangeState::Response::SharedPtr response) {
        const Step * chosen = step(state_, request->transition.id, request->transition.label);
        if (chosen == nullptr && !request->transition.label.empty()) {
          chosen = step(state_, request->transition.id, "");
        }
        CallbackReturn code = CallbackReturn::ERROR;
        if (chosen != nullptr) {
          trigger_transition(chosen->transition, code);
        } else {
          RCLCPP_WARN(get_logger(), "No transition matching %d found for current state %s",
            request->transition.id, get_current_state().label().c_str());
        }
        response->success = code == CallbackReturn::SUCCESS;
      }));
  parts_.push_back(rclcpp::create_service<GetState>(
      core_, "~/get_state", [this](GetState::Request::SharedPtr, GetState::Response::SharedPtr response) {
        response->current_state = message_of(get_current_state());
      }));
  parts_.push_back(rclcpp::create_service<GetAvailableStates>(
      core_, "~/get_available_states",
      [this](GetAvailableStates::Request::SharedPtr, GetAvailableStates::Response::SharedPtr response) {
        for (const State & state : get_available_states()) {
          response->available_states.push_back(message_of(state));
        }
      }));
  const auto add = [this](const std::string & name, bool all) {
      parts_.push_back(rclcpp::create_service<GetAvailableTransitions>(
          core_, name,
          [this, all](GetAvailableTransitions::Request::SharedPtr, GetAvailableTransitions::Response::SharedPtr response) {
            for (const Step & one : STEPS) {
              if (all || one.from == state_) {
                response->available_transitions.push_back(described(one));
              }
            }
          }));
    };
  add("~/get_available_transitions", false);
  add("~/get_transition_graph", true);
}

}  // namespace rclcpp_lifecycle
