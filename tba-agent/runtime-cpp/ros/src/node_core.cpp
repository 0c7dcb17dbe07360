#include "rclcpp/node_core.hpp"

#include <algorithm>
#include <set>

#include "case.hpp"
#include "names.hpp"
#include "rclcpp/node_api.hpp"

namespace rclcpp {

namespace kernel = sitaf_ros::kernel;
using sitaf_ros::Graph;

namespace node_interfaces {

NodeCore::NodeCore(const std::string & name, const std::string & name_space, const NodeOptions & given)
: options(given), name_(name), clock_(std::make_shared<Clock>(RCL_ROS_TIME))
{
  if (!options.context()->is_valid()) {
    throw exceptions::RCLInvalidArgument(
            "failed to create node: rcl node's context is invalid; call rclcpp::init() before");
  }
  auto rules = sitaf_ros::Case::get().remap;
  const auto own = sitaf_ros::rules_of(options.arguments());
  rules.insert(rules.begin(), own.begin(), own.end());
  const std::string problem = sitaf_ros::node_problem(name);
  if (!problem.empty()) {
    throw exceptions::InvalidNodeNameError(name, problem);
  }
  for (const char * key : {"__node", "__name"}) {
    const std::string renamed = sitaf_ros::special(key, rules, name);
    name_ = renamed.empty() ? name_ : renamed;
  }
  namespace_ = name_space.empty() || name_space[0] == '/' ? name_space : "/" + name_space;
  const std::string moved = sitaf_ros::special("__ns", rules, name);
  namespace_ = moved.empty() ? namespace_ : moved;
  if (namespace_.empty()) {
    namespace_ = "/";
  }
  const std::string wrong = namespace_ == "/" ? "" : sitaf_ros::topic_problem(namespace_);
  if (!wrong.empty()) {
    throw exceptions::InvalidNamespaceError(namespace_, wrong);
  }
  full_name_ = namespace_ == "/" ? "/" + name_ : namespace_ + "/" + name_;
  logger_name_ = full_name_.substr(1);
  std::replace(logger_name_.begin(), logger_name_.end(), '/', '.');
  groups_.push_back(std::make_shared<CallbackGroup>(CallbackGroupType::MutuallyExclusive));
  Graph::get().nodes.push_back(full_name_);
}

void NodeCore::begin()
{
  // The driver knows the overrides of the case.
  auto & settings = sitaf_ros::Case::get();
  settings.has_overrides = false;
  settings.events.push_back({sitaf_ros::EventKind::OVERRIDES, 0, 0, 0, name_ + "\n" + namespace_});
  while (!settings.has_overrides && kernel::in_fiber() && !kernel::ending()) {
    kernel::wait(&settings.has_overrides, std::nullopt, true);
  }
  for (const Parameter & parameter : options.parameter_overrides()) {
    overrides_[parameter.get_name()] = parameter.get_parameter_value();
  }
  if (settings.has_overrides) {
    const auto read = sitaf_ros::type_support<rcl_interfaces::msg::ParameterEvent>().read(settings.overrides);
    for (const auto & parameter : static_cast<rcl_interfaces::msg::ParameterEvent *>(read.get())->new_parameters) {
      overrides_[parameter.name] = ParameterValue(parameter.value);
      sitaf_ros::Unobserved::get().overrides.emplace(parameter.name, false);
    }
  }
  if (options.start_parameter_event_publisher()) {
    events_ = create_publisher<rcl_interfaces::msg::ParameterEvent>(
      shared_from_this(), "/parameter_events", ParameterEventsQoS());
  }
  if (options.start_parameter_services()) {
    make_services();
  }
  declare_parameter("use_sim_time", ParameterValue(settings.use_sim_time));
  if (options.automatically_declare_parameters_from_overrides()) {
    for (const auto & [name, value] : std::map(overrides_)) {
      if (!has_parameter(name)) {
        rcl_interfaces::msg::ParameterDescriptor descriptor;
        descriptor.dynamic_typing = true;
        declare_parameter(name, value, descriptor, true);
      }
    }
  }
}

NodeCore::~NodeCore()
{
  auto & nodes = Graph::get().nodes;
  const auto found = std::find(nodes.begin(), nodes.end(), full_name_);
  if (found != nodes.end()) {
    nodes.erase(found);
  }
}

CallbackGroup::SharedPtr NodeCore::create_callback_group(CallbackGroupType type, bool automatic)
{
  groups_.push_back(std::make_shared<CallbackGroup>(type, automatic));
  return groups_.back();
}

bool NodeCore::callback_group_in_node(const CallbackGroup::SharedPtr & group)
{
  return std::find(groups_.begin(), groups_.end(), group) != groups_.end();
}

void NodeCore::for_each_callback_group(const std::function<void(CallbackGroup::SharedPtr)> & act)
{
  for (const auto & group : std::vector(groups_)) {
    act(group);
  }
}

void NodeCore::add(const std::shared_ptr<sitaf_ros::Entity> & entity, const CallbackGroup::SharedPtr & group)
{
  if (group != nullptr && !callback_group_in_node(group)) {
    throw std::runtime_error("Cannot create an entity, callback group not in node.");
  }
  (group == nullptr ? groups_.front() : group)->sitaf_add(entity);
  sitaf_ros::work_appeared();
}

void NodeCore::add_timer(const std::shared_ptr<TimerBase> & timer, const CallbackGroup::SharedPtr & group)
{
  timer->name_callback(
    std::string("the callback of a timer of the node ") + full_name_);
  add(timer, group);
}

std::string NodeCore::resolve(const std::string & name) const
{
  auto rules = sitaf_ros::rules_of(options.arguments());
  const auto & given = sitaf_ros::Case::get().remap;
  rules.insert(rules.end(), given.begin(), given.end());
  return sitaf_ros::remapped(name, rules, name_, namespace_);
}

std::string NodeCore::resolve_topic_name(const std::string & name, bool only_expand) const
{
  return only_expand ? sitaf_ros::expand(name, name_, namespace_) : resolve(name);
}

// Graph.

namespace {

void put(std::map<std::string, std::vector<std::string>> & into, const std::string & name, const std::string & type)
{
  auto & types = into[name];
  if (std::find(types.begin(), types.end(), type) == types.end()) {
    types.push_back(type);
  }
}

/// Name and namespace of a node from its full name.
std::pair<std::string, std::string> parted(const std::string & full)
{
  const auto at = full.rfind('/');
  return {at == std::string::npos ? full : full.substr(at + 1),
    at == std::string::npos || at == 0 ? "/" : full.substr(0, at)};
}

std::string joined(const std::string & node, const std::string & name_space)
{
  return name_space.empty() || name_space == "/" ? "/" + node : name_space + "/" + node;
}

/// What a node has of publications, subscriptions, servers or clients; an unknown node is an error, as in rcl.
template<class T, class Name>
std::map<std::string, std::vector<std::string>> names_of(
  const std::vector<std::shared_ptr<T>> & all, const std::string & node, const std::string & name_space, Name name)
{
  const std::string full = joined(node, name_space);
  const auto & nodes = Graph::get().nodes;
  if (std::find(nodes.begin(), nodes.end(), full) == nodes.end()) {
    throw exceptions::RCLError("failed to get names and types of the node " + full + ": node name not found");
  }
  std::map<std::string, std::vector<std::string>> found;
  for (const auto & one : all) {
    if (one->node == full) {
      put(found, name(*one), one->type);
    }
  }
  return found;
}

}  // namespace

std::map<std::string, std::vector<std::string>> NodeCore::get_service_names_and_types_by_node(
  const std::string & node, const std::string & name_space) const
{
  return names_of(Graph::get().servers, node, name_space, [](const auto & one) {return one.name;});
}
std::map<std::string, std::vector<std::string>> NodeCore::get_client_names_and_types_by_node(
  const std::string & node, const std::string & name_space) const
{
  return names_of(Graph::get().clients, node, name_space, [](const auto & one) {return one.name;});
}
std::map<std::string, std::vector<std::string>> NodeCore::get_publisher_names_and_types_by_node(
  const std::string & node, const std::string & name_space, bool) const
{
  return names_of(Graph::get().publications, node, name_space, [](const auto & one) {return one.topic;});
}
std::map<std::string, std::vector<std::string>> NodeCore::get_subscriber_names_and_types_by_node(
  const std::string & node, const std::string & name_space, bool) const
{
  return names_of(Graph::get().subscriptions, node, name_space, [](const auto & one) {return one.topic;});
}

std::vector<std::pair<std::string, std::string>> NodeCore::get_node_names_and_namespaces() const
{
  std::vector<std::pair<std::string, std::string>> found;
  for (const auto & node : Graph::get().nodes) {
    found.push_back(parted(node));
  }
  return found;
}

std::map<std::string, std::vector<std::string>> NodeCore::get_topic_names_and_types(bool) const
{
  std::map<std::string, std::vector<std::string>> found;
  for (const auto & publication : Graph::get().publications) {
    put(found, publication->topic, publication->type);
  }
  for (const auto & subscribed : Graph::get().subscriptions) {
    put(found, subscribed->topic, subscribed->type);
  }
  return found;
}

std::map<std::string, std::vector<std::string>> NodeCore::get_service_names_and_types() const
{
  std::map<std::string, std::vector<std::string>> found;
  for (const auto & server : Graph::get().servers) {
    put(found, server->name, server->type);
  }
  return found;
}

std::vector<std::string> NodeCore::get_node_names() const {return Graph::get().nodes;}

std::size_t NodeCore::count_publishers(const std::string & topic) const
{
  const auto & all = Graph::get().publications;
  const std::string name = resolve(topic);
  return std::count_if(all.begin(), all.end(), [&](const auto & p) {return p->topic == name;});
}
std::size_t NodeCore::count_subscribers(const std::string & topic) const
{
  const auto & all = Graph::get().subscriptions;
  const std::string name = resolve(topic);
  return std::count_if(all.begin(), all.end(), [&](const auto & s) {return s->topic == name;});
}
std::size_t NodeCore::count_services(const std::string & service) const
{
  const auto & all = Graph::get().servers;
  const std::string name = resolve(service);
  return std::count_if(all.begin(), all.end(), [&](const auto & s) {return s->name == name;});
}
std::size_t NodeCore::count_clients(const std::string & service) const
{
  const auto & all = Graph::get().clients;
  const std::string name = resolve(service);
  return std::count_if(all.begin(), all.end(), [&](const auto & c) {return c->name == name;});
}

bool NodeCore::wait_for_change(std::uint64_t & seen, std::chrono::nanoseconds time)
{
  auto & graph = Graph::get();
  const bool limited = time.count() >= 0;
  const sitaf_ros::Nanos until = kernel::now() + (limited ? time.count() : 0);
  while (seen == graph.changes && !kernel::ending() && !(limited && kernel::now() >= until)) {
    kernel::wait(&graph.changes, limited ? std::optional(until) : std::nullopt, true);
  }
  return seen != graph.changes;
}

}  // namespace node_interfaces

NodeApi::NodeApi(const std::string & name, const std::string & name_space, const NodeOptions & options)
: core_(std::make_shared<node_interfaces::NodeCore>(name, name_space, options))
{
  core_->begin();
}

NodeApi::~NodeApi() = default;

namespace {

QoS qos_of(const sitaf_ros::Quality & quality)
{
  QoS qos(quality.depth);
  if (quality.keep_all) {
    qos.keep_all();
  }
  qos.reliability(quality.reliable ? ReliabilityPolicy::Reliable : ReliabilityPolicy::BestEffort);
  qos.durability(quality.transient_local ? DurabilityPolicy::TransientLocal : DurabilityPolicy::Volatile);
  return qos;
}

template<class T>
std::vector<TopicEndpointInfo> infos(
  const std::vector<std::shared_ptr<T>> & all, const std::string & topic, EndpointType endpoint)
{
  std::vector<TopicEndpointInfo> found;
  for (const auto & one : all) {
    if (one->topic == topic) {
      const auto [node, name_space] = node_interfaces::parted(one->node);
      found.emplace_back(node, name_space, one->type, qos_of(one->quality), endpoint);
    }
  }
  return found;
}

}  // namespace

std::vector<TopicEndpointInfo> NodeApi::get_publishers_info_by_topic(const std::string & topic, bool) const
{
  return infos(Graph::get().publications, core_->resolve(topic), EndpointType::Publisher);
}

std::vector<TopicEndpointInfo> NodeApi::get_subscriptions_info_by_topic(const std::string & topic, bool) const
{
  return infos(Graph::get().subscriptions, core_->resolve(topic), EndpointType::Subscription);
}

std::string expand_topic_or_service_name(
  const std::string & name, const std::string & node_name, const std::string & node_namespace, bool)
{
  const std::string problem = sitaf_ros::topic_problem(name);
  if (!problem.empty()) {
    throw exceptions::InvalidTopicNameError(name, problem);
  }
  return sitaf_ros::expand(name, node_name, node_namespace);
}

}  // namespace rclcpp
