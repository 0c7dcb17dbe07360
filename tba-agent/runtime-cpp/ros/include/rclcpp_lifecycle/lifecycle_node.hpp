#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "lifecycle_msgs/msg/state.hpp"
#include "lifecycle_msgs/msg/transition.hpp"
#include "lifecycle_msgs/msg/transition_event.hpp"
#include "rclcpp/rclcpp.hpp"

#define RCLCPP_LIFECYCLE_PUBLIC

namespace rclcpp_lifecycle {

class State
{
public:
  State() = default;
  explicit State(std::uint8_t id, const std::string & label = "")
  : id_(id), label_(label) {}
  std::uint8_t id() const {return id_;}
  std::string label() const {return label_;}

private:
  std::uint8_t id_ = 0;
  std::string label_ = "unknown";
};

class Transition
{
public:
  explicit Transition(std::uint8_t id, const std::string & label = "")
  : id_(id), label_(label) {}
  Transition(std::uint8_t id, const std::string & label, State start, State goal)
  : id_(id), label_(label), start_(std::move(start)), goal_(std::move(goal)) {}
  std::uint8_t id() const {return id_;}
  std::string label() const {return label_;}
  State start_state() const {return start_;}
  State goal_state() const {return goal_;}

private:
  std::uint8_t id_;
  std::string label_;
  State start_, goal_;
};

class ManagedEntityInterface
{
public:
  virtual ~ManagedEntityInterface() = default;
  virtual void on_activate() = 0;
  virtual void on_deactivate() = 0;
};

class SimpleManagedEntity : public ManagedEntityInterface
{
public:
  void on_activate() override {active_ = true;}
  void on_deactivate() override {active_ = false;}
  bool is_activated() const {return active_;}

private:
  bool active_ = false;
};

class LifecyclePublisherInterface : public SimpleManagedEntity {};

template<class T, class A = std::allocator<void>>
class LifecyclePublisher : public SimpleManagedEntity, public rclcpp::Publisher<T, A>
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(LifecyclePublisher)

  LifecyclePublisher(
    rclcpp::node_interfaces::NodeCore & node, const std::string & topic, const rclcpp::QoS & qos,
    const rclcpp::PublisherOptionsBase & options)
  : rclcpp::Publisher<T, A>(node, topic, qos, options), logger_(node.get_logger()) {}

  bool sitaf_is_open() override
  {
    if (!is_activated() && !warned_) {
      warned_ = true;
      RCLCPP_WARN(
        logger_, "Trying to publish message on the topic '%s', but the publisher is not activated",
        this->get_topic_name());
    }
    return is_activated();
  }
  void on_activate() override
  {
    warned_ = false;
    SimpleManagedEntity::on_activate();
  }

private:
  rclcpp::Logger logger_;
  bool warned_ = false;
};

namespace node_interfaces {

class LifecycleNodeInterface
{
public:
  enum class CallbackReturn : std::uint8_t
  {
    SUCCESS = lifecycle_msgs::msg::Transition::TRANSITION_CALLBACK_SUCCESS,
    FAILURE = lifecycle_msgs::msg::Transition::TRANSITION_CALLBACK_FAILURE,
    ERROR = lifecycle_msgs::msg::Transition::TRANSITION_CALLBACK_ERROR
  };
  virtual ~LifecycleNodeInterface() = default;
  virtual CallbackReturn on_configure(const State &) {return CallbackReturn::SUCCESS;}
  virtual CallbackReturn on_cleanup(const State &) {return CallbackReturn::SUCCESS;}
  virtual CallbackReturn on_shutdown(const State &) {return CallbackReturn::SUCCESS;}
  virtual CallbackReturn on_activate(const State &) {return CallbackReturn::SUCCESS;}
  virtual CallbackReturn on_deactivate(const State &) {return CallbackReturn::SUCCESS;}
  virtual CallbackReturn on_error(const State &) {return CallbackReturn::FAILURE;}
};

}  // namespace node_interfaces

class LifecycleNode : public rclcpp::NodeApi, public node_interfaces::LifecycleNodeInterface,
  public std::enable_shared_from_this<LifecycleNode>
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(LifecycleNode)
  using CallbackReturn = node_interfaces::LifecycleNodeInterface::CallbackReturn;

  explicit LifecycleNode(
    const std::string & name, const rclcpp::NodeOptions & options = rclcpp::NodeOptions(), bool services = true)
  : LifecycleNode(name, "", options, services) {}
  LifecycleNode(
    const std::string & name, const std::string & name_space,
    const rclcpp::NodeOptions & options = rclcpp::NodeOptions(), bool services = true);
  ~LifecycleNode() override;

  template<class T, class A = std::allocator<void>>
  std::shared_ptr<LifecyclePublisher<T, A>> create_publisher(
    const std::string & topic, const rclcpp::QoS & qos,
    const rclcpp::PublisherOptionsWithAllocator<A> & options = rclcpp::PublisherOptionsWithAllocator<A>())
  {
    auto made = rclcpp::create_publisher<T, A, LifecyclePublisher<T, A>>(core_, topic, qos, options);
    add_managed_entity(made);
    return made;
  }
  void add_managed_entity(std::weak_ptr<ManagedEntityInterface> entity) {entities_.push_back(std::move(entity));}
  void add_timer_handle(std::shared_ptr<rclcpp::TimerBase>) {}

  const State & get_current_state() const;
  std::vector<State> get_available_states() const;
  std::vector<Transition> get_available_transitions() const;
  std::vector<Transition> get_transition_graph() const;
  const State & trigger_transition(const Transition & transition) {return trigger_transition(transition.id());}
  const State & trigger_transition(const Transition & transition, CallbackReturn & code)
  {
    return trigger_transition(transition.id(), code);
  }
  const State & trigger_transition(std::uint8_t id);
  const State & trigger_transition(std::uint8_t id, CallbackReturn & code);
  const State & configure();
  const State & configure(CallbackReturn & code);
  const State & cleanup();
  const State & cleanup(CallbackReturn & code);
  const State & activate();
  const State & activate(CallbackReturn & code);
  const State & deactivate();
  const State & deactivate(CallbackReturn & code);
  const State & shutdown();
  const State & shutdown(CallbackReturn & code);

#define SITAF_REGISTER(name) \
  bool register_ ## name(std::function<CallbackReturn(const State &)> callback) \
  { \
    registered_[#name] = std::move(callback); \
    return true; \
  }
  SITAF_REGISTER(on_configure)
  SITAF_REGISTER(on_cleanup)
  SITAF_REGISTER(on_shutdown)
  SITAF_REGISTER(on_activate)
  SITAF_REGISTER(on_deactivate)
  SITAF_REGISTER(on_error)
#undef SITAF_REGISTER

  // The defaults of the interface also tell the publishers.
  CallbackReturn on_activate(const State & previous) override;
  CallbackReturn on_deactivate(const State & previous) override;

private:
  CallbackReturn call(const std::string & name, const State & previous);
  void enter(std::uint8_t state, std::uint8_t transition);
  void make_services();

  std::uint8_t state_;
  std::vector<std::weak_ptr<ManagedEntityInterface>> entities_;
  std::map<std::string, std::function<CallbackReturn(const State &)>> registered_;
  std::vector<std::shared_ptr<void>> parts_;
  std::shared_ptr<rclcpp::Publisher<lifecycle_msgs::msg::TransitionEvent>> event_;
};

}  // namespace rclcpp_lifecycle
