#include "rclcpp/wait_set.hpp"

namespace rclcpp {

namespace kernel = sitaf_ros::kernel;

WaitResultKind WaitSet::wait_for(sitaf_ros::Nanos nanos)
{
  if (subscriptions_.empty() && guards_.empty() && timers_.empty() && clients_.empty() && services_.empty()) {
    return WaitResultKind::Empty;
  }
  const std::optional<sitaf_ros::Nanos> until =
    nanos < 0 ? std::nullopt : std::optional<sitaf_ros::Nanos>(kernel::now() + nanos);
  while (true) {
    bool any = false;
    const auto look = [&any](const auto & list, std::vector<const void *> & into) {
        into.clear();
        for (const auto & one : list) {
          const bool ready = one->order().has_value();
          into.push_back(ready ? one.get() : nullptr);
          any |= ready;
        }
      };
    look(subscriptions_, ready_.subscriptions);
    look(timers_, ready_.timers);
    look(guards_, ready_.guard_conditions);
    look(clients_, ready_.clients);
    look(services_, ready_.services);
    ready_.size_of_subscriptions = subscriptions_.size();
    ready_.size_of_timers = timers_.size();
    ready_.size_of_guard_conditions = guards_.size();
    ready_.size_of_clients = clients_.size();
    ready_.size_of_services = services_.size();
    if (any) {
      for (const auto & guard : guards_) {
        guard->sitaf_taken();
      }
      kernel::count_callback();
      return WaitResultKind::Ready;
    }
    if (kernel::ending() || !rclcpp::ok() || (until && kernel::now() >= *until)) {
      return WaitResultKind::Timeout;
    }
    auto deadline = until;
    for (const auto & timer : timers_) {
      const auto due = timer->due();
      if (due && *due > kernel::now() && (!deadline || *due < *deadline)) {
        deadline = due;
      }
    }
    kernel::wait(sitaf_ros::work(), deadline, true);
  }
}

}  // namespace rclcpp
