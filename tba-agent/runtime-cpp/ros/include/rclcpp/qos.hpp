#pragma once

#include <cstddef>
#include <ostream>
#include <string>

#include "rclcpp/duration.hpp"
#include "sitaf_ros/graph.hpp"

typedef enum {
  RMW_QOS_POLICY_HISTORY_SYSTEM_DEFAULT, RMW_QOS_POLICY_HISTORY_KEEP_LAST, RMW_QOS_POLICY_HISTORY_KEEP_ALL,
  RMW_QOS_POLICY_HISTORY_UNKNOWN
} rmw_qos_history_policy_t;
typedef enum {
  RMW_QOS_POLICY_RELIABILITY_SYSTEM_DEFAULT, RMW_QOS_POLICY_RELIABILITY_RELIABLE,
  RMW_QOS_POLICY_RELIABILITY_BEST_EFFORT, RMW_QOS_POLICY_RELIABILITY_UNKNOWN,
  RMW_QOS_POLICY_RELIABILITY_BEST_AVAILABLE
} rmw_qos_reliability_policy_t;
typedef enum {
  RMW_QOS_POLICY_DURABILITY_SYSTEM_DEFAULT, RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL,
  RMW_QOS_POLICY_DURABILITY_VOLATILE, RMW_QOS_POLICY_DURABILITY_UNKNOWN, RMW_QOS_POLICY_DURABILITY_BEST_AVAILABLE
} rmw_qos_durability_policy_t;
typedef enum {
  RMW_QOS_POLICY_LIVELINESS_SYSTEM_DEFAULT = 0, RMW_QOS_POLICY_LIVELINESS_AUTOMATIC = 1,
  RMW_QOS_POLICY_LIVELINESS_MANUAL_BY_TOPIC = 3, RMW_QOS_POLICY_LIVELINESS_UNKNOWN = 4,
  RMW_QOS_POLICY_LIVELINESS_BEST_AVAILABLE = 5
} rmw_qos_liveliness_policy_t;

typedef struct rmw_qos_profile_s
{
  rmw_qos_history_policy_t history = RMW_QOS_POLICY_HISTORY_KEEP_LAST;
  std::size_t depth = 10;
  rmw_qos_reliability_policy_t reliability = RMW_QOS_POLICY_RELIABILITY_RELIABLE;
  rmw_qos_durability_policy_t durability = RMW_QOS_POLICY_DURABILITY_VOLATILE;
  rmw_time_t deadline{0, 0};
  rmw_time_t lifespan{0, 0};
  rmw_qos_liveliness_policy_t liveliness = RMW_QOS_POLICY_LIVELINESS_SYSTEM_DEFAULT;
  rmw_time_t liveliness_lease_duration{0, 0};
  bool avoid_ros_namespace_conventions = false;
} rmw_qos_profile_t;

static const rmw_qos_profile_t rmw_qos_profile_default{};
static const rmw_qos_profile_t rmw_qos_profile_system_default{
  RMW_QOS_POLICY_HISTORY_SYSTEM_DEFAULT, 0, RMW_QOS_POLICY_RELIABILITY_SYSTEM_DEFAULT,
  RMW_QOS_POLICY_DURABILITY_SYSTEM_DEFAULT};
static const rmw_qos_profile_t rmw_qos_profile_sensor_data{
  RMW_QOS_POLICY_HISTORY_KEEP_LAST, 5, RMW_QOS_POLICY_RELIABILITY_BEST_EFFORT, RMW_QOS_POLICY_DURABILITY_VOLATILE};
static const rmw_qos_profile_t rmw_qos_profile_services_default{};
static const rmw_qos_profile_t rmw_qos_profile_parameters{RMW_QOS_POLICY_HISTORY_KEEP_LAST, 1000};
static const rmw_qos_profile_t rmw_qos_profile_parameter_events{RMW_QOS_POLICY_HISTORY_KEEP_LAST, 1000};
static const rmw_qos_profile_t rcl_action_qos_profile_status_default{
  RMW_QOS_POLICY_HISTORY_KEEP_LAST, 1, RMW_QOS_POLICY_RELIABILITY_RELIABLE, RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL};

typedef enum
{
  RMW_QOS_POLICY_INVALID = 1, RMW_QOS_POLICY_DURABILITY = 2, RMW_QOS_POLICY_DEADLINE = 4,
  RMW_QOS_POLICY_LIVELINESS = 8, RMW_QOS_POLICY_RELIABILITY = 16, RMW_QOS_POLICY_HISTORY = 32,
  RMW_QOS_POLICY_LIFESPAN = 64
} rmw_qos_policy_kind_t;

namespace rclcpp {

enum class HistoryPolicy
{
  KeepLast = RMW_QOS_POLICY_HISTORY_KEEP_LAST, KeepAll = RMW_QOS_POLICY_HISTORY_KEEP_ALL,
  SystemDefault = RMW_QOS_POLICY_HISTORY_SYSTEM_DEFAULT, Unknown = RMW_QOS_POLICY_HISTORY_UNKNOWN
};
enum class ReliabilityPolicy
{
  BestEffort = RMW_QOS_POLICY_RELIABILITY_BEST_EFFORT, Reliable = RMW_QOS_POLICY_RELIABILITY_RELIABLE,
  SystemDefault = RMW_QOS_POLICY_RELIABILITY_SYSTEM_DEFAULT,
  BestAvailable = RMW_QOS_POLICY_RELIABILITY_BEST_AVAILABLE, Unknown = RMW_QOS_POLICY_RELIABILITY_UNKNOWN
};
enum class DurabilityPolicy
{
  Volatile = RMW_QOS_POLICY_DURABILITY_VOLATILE, TransientLocal = RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL,
  SystemDefault = RMW_QOS_POLICY_DURABILITY_SYSTEM_DEFAULT,
  BestAvailable = RMW_QOS_POLICY_DURABILITY_BEST_AVAILABLE, Unknown = RMW_QOS_POLICY_DURABILITY_UNKNOWN
};
enum class LivelinessPolicy
{
  Automatic = RMW_QOS_POLICY_LIVELINESS_AUTOMATIC, ManualByTopic = RMW_QOS_POLICY_LIVELINESS_MANUAL_BY_TOPIC,
  SystemDefault = RMW_QOS_POLICY_LIVELINESS_SYSTEM_DEFAULT,
  BestAvailable = RMW_QOS_POLICY_LIVELINESS_BEST_AVAILABLE, Unknown = RMW_QOS_POLICY_LIVELINESS_UNKNOWN
};

struct QoSInitialization
{
  rmw_qos_history_policy_t history_policy;
  std::size_t depth;

  QoSInitialization(rmw_qos_history_policy_t history, std::size_t count, bool = false)
  : history_policy(history), depth(count) {}
  static QoSInitialization from_rmw(const rmw_qos_profile_t & profile) {return {profile.history, profile.depth};}
};

struct KeepAll : QoSInitialization
{
  KeepAll()
  : QoSInitialization(RMW_QOS_POLICY_HISTORY_KEEP_ALL, 0) {}
};

struct KeepLast : QoSInitialization
{
  explicit KeepLast(std::size_t count, bool = true)
  : QoSInitialization(RMW_QOS_POLICY_HISTORY_KEEP_LAST, count) {}
};

class QoS
{
public:
  QoS(const QoSInitialization & begun, const rmw_qos_profile_t & profile = rmw_qos_profile_default)
  : profile_(profile)
  {
    profile_.history = begun.history_policy;
    profile_.depth = begun.depth;
  }
  QoS(std::size_t depth)
  : QoS(KeepLast(depth)) {}

  rmw_qos_profile_t & get_rmw_qos_profile() {return profile_;}
  const rmw_qos_profile_t & get_rmw_qos_profile() const {return profile_;}

  QoS & history(HistoryPolicy policy) {return history(static_cast<rmw_qos_history_policy_t>(policy));}
  QoS & history(rmw_qos_history_policy_t policy) {profile_.history = policy; return *this;}
  QoS & keep_last(std::size_t depth)
  {
    profile_.history = RMW_QOS_POLICY_HISTORY_KEEP_LAST;
    profile_.depth = depth;
    return *this;
  }
  QoS & keep_all() {profile_.history = RMW_QOS_POLICY_HISTORY_KEEP_ALL; profile_.depth = 0; return *this;}
  QoS & reliability(rmw_qos_reliability_policy_t policy) {profile_.reliability = policy; return *this;}
  QoS & reliability(ReliabilityPolicy policy) {return reliability(static_cast<rmw_qos_reliability_policy_t>(policy));}
  QoS & reliable() {return reliability(RMW_QOS_POLICY_RELIABILITY_RELIABLE);}
  QoS & best_effort() {return reliability(RMW_QOS_POLICY_RELIABILITY_BEST_EFFORT);}
  QoS & reliability_best_available() {return reliability(RMW_QOS_POLICY_RELIABILITY_BEST_AVAILABLE);}
  QoS & durability(rmw_qos_durability_policy_t policy) {profile_.durability = policy; return *this;}
  QoS & durability(DurabilityPolicy policy) {return durability(static_cast<rmw_qos_durability_policy_t>(policy));}
  QoS & durability_volatile() {return durability(RMW_QOS_POLICY_DURABILITY_VOLATILE);}
  QoS & transient_local() {return durability(RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL);}
  QoS & durability_best_available() {return durability(RMW_QOS_POLICY_DURABILITY_BEST_AVAILABLE);}
  QoS & deadline(rmw_time_t time) {profile_.deadline = time; return *this;}
  QoS & deadline(const Duration & time) {return deadline(time.to_rmw_time());}
  QoS & lifespan(rmw_time_t time) {profile_.lifespan = time; return *this;}
  QoS & lifespan(const Duration & time) {return lifespan(time.to_rmw_time());}
  QoS & liveliness(rmw_qos_liveliness_policy_t policy) {profile_.liveliness = policy; return *this;}
  QoS & liveliness(LivelinessPolicy policy) {return liveliness(static_cast<rmw_qos_liveliness_policy_t>(policy));}
  QoS & liveliness_lease_duration(rmw_time_t time) {profile_.liveliness_lease_duration = time; return *this;}
  QoS & liveliness_lease_duration(const Duration & time) {return liveliness_lease_duration(time.to_rmw_time());}
  QoS & avoid_ros_namespace_conventions(bool avoid) {profile_.avoid_ros_namespace_conventions = avoid; return *this;}

  HistoryPolicy history() const {return static_cast<HistoryPolicy>(profile_.history);}
  std::size_t depth() const {return profile_.depth;}
  ReliabilityPolicy reliability() const {return static_cast<ReliabilityPolicy>(profile_.reliability);}
  DurabilityPolicy durability() const {return static_cast<DurabilityPolicy>(profile_.durability);}
  Duration deadline() const {return Duration::from_rmw_time(profile_.deadline);}
  Duration lifespan() const {return Duration::from_rmw_time(profile_.lifespan);}
  LivelinessPolicy liveliness() const {return static_cast<LivelinessPolicy>(profile_.liveliness);}
  Duration liveliness_lease_duration() const
  {
    return Duration::from_rmw_time(profile_.liveliness_lease_duration);
  }
  bool avoid_ros_namespace_conventions() const {return profile_.avoid_ros_namespace_conventions;}

  sitaf_ros::Quality sitaf_quality(bool offered) const;

private:
  rmw_qos_profile_t profile_;
};

bool operator==(const QoS & a, const QoS & b);
inline bool operator!=(const QoS & a, const QoS & b) {return !(a == b);}
std::ostream & operator<<(std::ostream & out, const QoS & qos);

class ClockQoS : public QoS
{
public:
  explicit ClockQoS(const QoSInitialization & begun = KeepLast(1))
  : QoS(begun, rmw_qos_profile_sensor_data) {}
};
class SensorDataQoS : public QoS
{
public:
  explicit SensorDataQoS(const QoSInitialization & begun = KeepLast(5))
  : QoS(begun, rmw_qos_profile_sensor_data) {}
};
class ParametersQoS : public QoS
{
public:
  explicit ParametersQoS(const QoSInitialization & begun = KeepLast(1000))
  : QoS(begun, rmw_qos_profile_parameters) {}
};
class ServicesQoS : public QoS
{
public:
  explicit ServicesQoS(const QoSInitialization & begun = KeepLast(10))
  : QoS(begun, rmw_qos_profile_services_default) {}
};
class ParameterEventsQoS : public QoS
{
public:
  explicit ParameterEventsQoS(const QoSInitialization & begun = KeepLast(1000))
  : QoS(begun, rmw_qos_profile_parameter_events) {}
};
class RosoutQoS : public QoS
{
public:
  explicit RosoutQoS(const QoSInitialization & begun = KeepLast(1000))
  : QoS(begun) {transient_local();}
};
class SystemDefaultsQoS : public QoS
{
public:
  explicit SystemDefaultsQoS(const QoSInitialization & begun = {RMW_QOS_POLICY_HISTORY_SYSTEM_DEFAULT, 0})
  : QoS(begun, rmw_qos_profile_system_default) {}
};
class BestAvailableQoS : public QoS
{
public:
  explicit BestAvailableQoS(const QoSInitialization & begun = KeepLast(10))
  : QoS(begun) {reliability_best_available().durability_best_available();}
};

enum class QosPolicyKind
{
  Invalid = RMW_QOS_POLICY_INVALID, Deadline = RMW_QOS_POLICY_DEADLINE, Depth = 128,
  Durability = RMW_QOS_POLICY_DURABILITY, History = RMW_QOS_POLICY_HISTORY, Lifespan = RMW_QOS_POLICY_LIFESPAN,
  Liveliness = RMW_QOS_POLICY_LIVELINESS, Reliability = RMW_QOS_POLICY_RELIABILITY
};

std::string qos_policy_name_from_kind(rmw_qos_policy_kind_t kind);

}  // namespace rclcpp
