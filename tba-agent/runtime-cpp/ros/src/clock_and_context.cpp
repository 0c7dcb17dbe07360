#include <algorithm>

#include "case.hpp"
#include "rclcpp/clock.hpp"
#include "rclcpp/context.hpp"
#include "rclcpp/qos.hpp"

namespace rclcpp {

namespace kernel = sitaf_ros::kernel;

Time Clock::now() const
{
  const std::int64_t wall = kernel::look();
  return Time(ros_time_is_active() ? wall - sitaf_ros::EPOCH : wall, type_);
}

bool Clock::ros_time_is_active() const
{
  return type_ == RCL_ROS_TIME && sitaf_ros::Case::get().use_sim_time;
}

std::int64_t Clock::sitaf_when(const Time & time) const
{
  return ros_time_is_active() ? time.nanoseconds() : time.nanoseconds() - sitaf_ros::EPOCH;
}

bool Clock::sleep_until(Time until, Context::SharedPtr context)
{
  if (until.get_clock_type() != type_) {
    throw std::runtime_error("until's clock type does not match this clock's type");
  }
  kernel::sleep_until(sitaf_when(until));
  return !kernel::ending() && rclcpp::ok(context);
}

bool Clock::sleep_for(Duration time, Context::SharedPtr context) {return sleep_until(now() + time, context);}

void Context::init(int argc, const char * const * argv, const InitOptions & options)
{
  if (is_valid()) {
    throw std::runtime_error("context is already initialized");
  }
  valid_ = true;
  options_ = options;
  sitaf_arguments.clear();
  for (int i = 1; i < argc && argv != nullptr; ++i) {
    sitaf_arguments.emplace_back(argv[i]);
  }
}

bool Context::is_valid() const
{
  return valid_ && !(kernel::ending() && kernel::in_fiber());
}

bool Context::shutdown(const std::string & reason)
{
  if (!valid_) {
    return false;
  }
  for (const auto & callback : std::vector(pre_callbacks_)) {
    (*callback)();
  }
  valid_ = false;
  reason_ = reason;
  for (const auto & callback : std::vector(callbacks_)) {
    (*callback)();
  }
  kernel::wake(this);
  sitaf_ros::Graph::get().changed();
  return true;
}

std::function<void()> Context::on_shutdown(std::function<void()> callback)
{
  add_on_shutdown_callback(callback);
  return callback;
}

OnShutdownCallbackHandle Context::add_on_shutdown_callback(std::function<void()> callback)
{
  callbacks_.push_back(std::make_shared<std::function<void()>>(std::move(callback)));
  return callbacks_.back();
}

PreShutdownCallbackHandle Context::add_pre_shutdown_callback(std::function<void()> callback)
{
  pre_callbacks_.push_back(std::make_shared<std::function<void()>>(std::move(callback)));
  return pre_callbacks_.back();
}

namespace {

bool removed(std::vector<OnShutdownCallbackHandle> & callbacks, const OnShutdownCallbackHandle & handle)
{
  const auto found = std::find(callbacks.begin(), callbacks.end(), handle);
  if (found == callbacks.end()) {
    return false;
  }
  callbacks.erase(found);
  return true;
}

}  // namespace

bool Context::remove_on_shutdown_callback(const OnShutdownCallbackHandle & handle)
{
  return removed(callbacks_, handle);
}

bool Context::remove_pre_shutdown_callback(const PreShutdownCallbackHandle & handle)
{
  return removed(pre_callbacks_, handle);
}

bool Context::sleep_for(const std::chrono::nanoseconds & time)
{
  kernel::wait(this, kernel::now() + time.count());
  return is_valid();
}

void Context::interrupt_all_sleep_for() {kernel::wake(this);}

namespace contexts {

DefaultContext::SharedPtr get_global_default_context()
{
  static const auto context = std::make_shared<DefaultContext>();
  return context;
}

}  // namespace contexts

namespace {

Context & of(const Context::SharedPtr & context)
{
  return context == nullptr ? *contexts::get_global_default_context() : *context;
}

}  // namespace

void init(int argc, const char * const * argv, const InitOptions & options, SignalHandlerOptions)
{
  of(nullptr).init(argc, argv, options);
}

std::vector<std::string> init_and_remove_ros_arguments(
  int argc, const char * const * argv, const InitOptions & options)
{
  init(argc, argv, options);
  return remove_ros_arguments(argc, argv);
}

std::vector<std::string> remove_ros_arguments(int argc, const char * const * argv)
{
  std::vector<std::string> kept;
  bool of_ros = false;
  for (int i = 0; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--ros-args") {
      of_ros = true;
    } else if (argument == "--" && of_ros) {
      of_ros = false;
    } else if (!of_ros) {
      kept.push_back(argument);
    }
  }
  return kept;
}

bool ok(Context::SharedPtr context)
{
  if (kernel::in_fiber() && !kernel::ending()) {
    kernel::look();  // a loop `while (ok())` that never waits takes time
  }
  return of(context).is_valid();
}
bool shutdown(Context::SharedPtr context, const std::string & reason) {return of(context).shutdown(reason);}
void on_shutdown(std::function<void()> callback, Context::SharedPtr context)
{
  of(context).on_shutdown(std::move(callback));
}
bool sleep_for(const std::chrono::nanoseconds & time, Context::SharedPtr context)
{
  return of(context).sleep_for(time);
}

// Quality of service.

sitaf_ros::Quality QoS::sitaf_quality(bool offered) const
{
  const auto nanos = [](rmw_time_t time) {
      const std::uint64_t most = sitaf_ros::INFINITE;
      return time.sec == 0 && time.nsec == 0 ? sitaf_ros::INFINITE :
             time.sec >= most / 1'000'000'000 ? sitaf_ros::INFINITE :
             static_cast<sitaf_ros::Nanos>(time.sec * 1'000'000'000 + time.nsec);
    };
  sitaf_ros::Quality quality;
  quality.depth = profile_.depth == 0 ? 10 : profile_.depth;
  quality.keep_all = profile_.history == RMW_QOS_POLICY_HISTORY_KEEP_ALL;
  // The best that is available is what any counterpart accepts.
  quality.reliable = profile_.reliability == RMW_QOS_POLICY_RELIABILITY_BEST_AVAILABLE ?
    offered : profile_.reliability != RMW_QOS_POLICY_RELIABILITY_BEST_EFFORT;
  quality.transient_local = profile_.durability == RMW_QOS_POLICY_DURABILITY_BEST_AVAILABLE ?
    offered : profile_.durability == RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL;
  quality.deadline = nanos(profile_.deadline);
  quality.lifespan = nanos(profile_.lifespan);
  quality.lease = nanos(profile_.liveliness_lease_duration);
  quality.manual_liveliness = profile_.liveliness == RMW_QOS_POLICY_LIVELINESS_MANUAL_BY_TOPIC;
  return quality;
}

bool operator==(const QoS & a, const QoS & b)
{
  return a.history() == b.history() && a.depth() == b.depth() && a.reliability() == b.reliability() &&
         a.durability() == b.durability() && a.deadline() == b.deadline() && a.lifespan() == b.lifespan() &&
         a.liveliness() == b.liveliness() && a.liveliness_lease_duration() == b.liveliness_lease_duration();
}

std::ostream & operator<<(std::ostream & out, const QoS & qos)
{
  return out << "QoS(depth: " << qos.depth() << ")";
}

std::string qos_policy_name_from_kind(rmw_qos_policy_kind_t kind)
{
  switch (kind) {
    case RMW_QOS_POLICY_DURABILITY: return "DURABILITY_QOS_POLICY";
    case RMW_QOS_POLICY_DEADLINE: return "DEADLINE_QOS_POLICY";
    case RMW_QOS_POLICY_LIVELINESS: return "LIVELINESS_QOS_POLICY";
    case RMW_QOS_POLICY_RELIABILITY: return "RELIABILITY_QOS_POLICY";
    case RMW_QOS_POLICY_HISTORY: return "HISTORY_QOS_POLICY";
    case RMW_QOS_POLICY_LIFESPAN: return "LIFESPAN_QOS_POLICY";
    default: return "INVALID_QOS_POLICY";
  }
}

}  // namespace rclcpp
