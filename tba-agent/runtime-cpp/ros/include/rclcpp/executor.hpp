#pragma once

#include <chrono>
#include <future>
#include <list>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "rclcpp/node.hpp"

namespace rclcpp {

enum class FutureReturnCode {SUCCESS, INTERRUPTED, TIMEOUT};
std::ostream & operator<<(std::ostream & out, FutureReturnCode code);
std::string to_string(FutureReturnCode code);

struct ExecutorOptions
{
  Context::SharedPtr context = contexts::get_global_default_context();
  std::shared_ptr<void> memory_strategy;
  std::size_t max_conditions = 0;
};

struct AnyExecutable
{
  std::shared_ptr<sitaf_ros::Entity> entity;
  CallbackGroup::SharedPtr group;
  std::function<void()> run;
};

class Executor
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Executor)

  explicit Executor(const ExecutorOptions & options = ExecutorOptions());
  virtual ~Executor();
  Executor(const Executor &) = delete;
  Executor & operator=(const Executor &) = delete;

  virtual void spin();
  template<class N>
  void add_node(N && node, bool = true) {add(detail::core(std::forward<N>(node)));}
  template<class N>
  void remove_node(N && node, bool = true) {remove(detail::core(std::forward<N>(node)));}
  virtual void add_callback_group(
    CallbackGroup::SharedPtr group, node_interfaces::NodeCore::SharedPtr node, bool = true);
  virtual void remove_callback_group(CallbackGroup::SharedPtr group, bool = true);
  std::vector<std::weak_ptr<CallbackGroup>> get_all_callback_groups();
  virtual void spin_some(std::chrono::nanoseconds most = std::chrono::nanoseconds(0));
  virtual void spin_all(std::chrono::nanoseconds most) {spin_some(most);}
  template<class R = std::int64_t, class P = std::milli>
  void spin_once(std::chrono::duration<R, P> timeout = std::chrono::duration<R, P>(-1))
  {
    spin_once_for(timeout.count() < 0 ? -1 : std::chrono::duration_cast<std::chrono::nanoseconds>(timeout).count());
  }
  template<class N, class R = std::int64_t, class P = std::milli>
  void spin_node_once(N && node, std::chrono::duration<R, P> timeout = std::chrono::duration<R, P>(-1))
  {
    add_node(node);
    spin_once(timeout);
    remove_node(node);
  }
  template<class N>
  void spin_node_some(N && node)
  {
    add_node(node);
    spin_some();
    remove_node(node);
  }
  template<class F, class R = std::int64_t, class P = std::milli>
  FutureReturnCode spin_until_future_complete(
    const F & future, std::chrono::duration<R, P> timeout = std::chrono::duration<R, P>(-1))
  {
    const auto & waited = const_cast<F &>(future);
    return spin_until(
      [&] {return waited.wait_for(std::chrono::seconds(0)) == std::future_status::ready;},
      timeout.count() < 0 ? -1 : std::chrono::duration_cast<std::chrono::nanoseconds>(timeout).count());
  }
  virtual void cancel();
  bool is_spinning() {return spinning_ > 0;}

protected:
  bool next(AnyExecutable & found);
  void execute(AnyExecutable & found);
  /// Runs one callback; waits for it at most to a time. Returns false if none came.
  bool run_one(std::optional<sitaf_ros::Nanos> until);
  bool goes_on() const;
  std::size_t running_ = 0;
  int spinning_ = 0;
  bool canceled_ = false;

private:
  void add(const node_interfaces::NodeCore::SharedPtr & node);
  void remove(const node_interfaces::NodeCore::SharedPtr & node);
  void spin_once_for(sitaf_ros::Nanos nanos);
  FutureReturnCode spin_until(const std::function<bool()> & done, sitaf_ros::Nanos nanos);
  std::vector<CallbackGroup::SharedPtr> groups();
  std::optional<sitaf_ros::Nanos> next_due();

  Context::SharedPtr context_;
  std::vector<std::weak_ptr<node_interfaces::NodeCore>> nodes_;
  std::vector<std::weak_ptr<CallbackGroup>> added_groups_;
};

namespace executors {

class SingleThreadedExecutor : public Executor
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(SingleThreadedExecutor)
  using Executor::Executor;
};

class StaticSingleThreadedExecutor : public Executor
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(StaticSingleThreadedExecutor)
  using Executor::Executor;
};

class MultiThreadedExecutor : public Executor
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(MultiThreadedExecutor)
  explicit MultiThreadedExecutor(
    const ExecutorOptions & options = ExecutorOptions(), std::size_t threads = 0, bool = false,
    std::chrono::nanoseconds = std::chrono::nanoseconds(-1))
  : Executor(options), threads_(threads == 0 ? 8 : threads) {}
  void spin() override;
  std::size_t get_number_of_threads() {return threads_;}

private:
  std::size_t threads_;
};

using rclcpp::FutureReturnCode;

template<class N, class F, class R = std::int64_t, class P = std::milli>
FutureReturnCode spin_node_until_future_complete(
  Executor & executor, N && node, const F & future,
  std::chrono::duration<R, P> timeout = std::chrono::duration<R, P>(-1))
{
  executor.add_node(node);
  const auto code = executor.spin_until_future_complete(future, timeout);
  executor.remove_node(node);
  return code;
}

}  // namespace executors

namespace experimental {
namespace executors {

class EventsExecutor : public Executor
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(EventsExecutor)
  EventsExecutor() = default;
};

}  // namespace executors
}  // namespace experimental

template<class N>
void spin(N && node)
{
  executors::SingleThreadedExecutor executor;
  executor.add_node(node);
  executor.spin();
  executor.remove_node(node);
}
template<class N>
void spin_some(N && node)
{
  executors::SingleThreadedExecutor executor;
  executor.spin_node_some(node);
}
template<class N>
void spin_all(N && node, std::chrono::nanoseconds)
{
  spin_some(node);
}
template<class N, class F, class R = std::int64_t, class P = std::milli>
FutureReturnCode spin_until_future_complete(
  N && node, const F & future, std::chrono::duration<R, P> timeout = std::chrono::duration<R, P>(-1))
{
  executors::SingleThreadedExecutor executor;
  return executors::spin_node_until_future_complete(executor, node, future, timeout);
}

}  // namespace rclcpp
