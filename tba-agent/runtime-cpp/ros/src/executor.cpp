#include "rclcpp/executor.hpp"

#include <algorithm>

#include "case.hpp"

namespace rclcpp {

namespace kernel = sitaf_ros::kernel;
using sitaf_ros::Nanos;

void CallbackGroup::sitaf_add(const std::shared_ptr<sitaf_ros::Entity> & entity) {entities_.push_back(entity);}

std::vector<std::shared_ptr<sitaf_ros::Entity>> CallbackGroup::sitaf_entities()
{
  std::vector<std::shared_ptr<sitaf_ros::Entity>> found;
  std::size_t kept = 0;
  for (auto & entity : entities_) {
    if (auto existing = entity.lock()) {
      found.push_back(std::move(existing));
      if (&entities_[kept] != &entity) {
        entities_[kept] = std::move(entity);
      }
      ++kept;
    }
  }
  entities_.resize(kept);
  return found;
}

bool CallbackGroup::sitaf_begins()
{
  if (type_ == CallbackGroupType::Reentrant) {
    return true;
  }
  return std::exchange(free_, false);
}

void CallbackGroup::sitaf_ends()
{
  free_ = true;
  sitaf_ros::work_appeared();
}

std::string to_string(FutureReturnCode code)
{
  return code == FutureReturnCode::SUCCESS ? "SUCCESS (0)" :
         code == FutureReturnCode::INTERRUPTED ? "INTERRUPTED (1)" : "TIMEOUT (2)";
}

std::ostream & operator<<(std::ostream & out, FutureReturnCode code) {return out << to_string(code);}

Executor::Executor(const ExecutorOptions & options)
: context_(options.context ? options.context : contexts::get_global_default_context()) {}

Executor::~Executor()
{
  for (const auto & weak : nodes_) {
    if (const auto node = weak.lock()) {
      node->has_executor = false;
    }
  }
}

void Executor::add(const node_interfaces::NodeCore::SharedPtr & node)
{
  if (node->has_executor) {
    throw std::runtime_error(
            std::string("Node '") + node->get_fully_qualified_name() + "' has already been added to an executor.");
  }
  node->has_executor = true;
  nodes_.push_back(node);
  sitaf_ros::work_appeared();
}

void Executor::remove(const node_interfaces::NodeCore::SharedPtr & node)
{
  nodes_.erase(
    std::remove_if(nodes_.begin(), nodes_.end(), [&](const auto & weak) {return weak.lock() == node;}), nodes_.end());
  node->has_executor = false;
}

void Executor::add_callback_group(CallbackGroup::SharedPtr group, node_interfaces::NodeCore::SharedPtr, bool)
{
  added_groups_.push_back(group);
  group->sitaf_executor = std::shared_ptr<void>(context_);
  sitaf_ros::work_appeared();
}

void Executor::remove_callback_group(CallbackGroup::SharedPtr group, bool)
{
  added_groups_.erase(
    std::remove_if(
      added_groups_.begin(), added_groups_.end(), [&](const auto & weak) {return weak.lock() == group;}),
    added_groups_.end());
  group->sitaf_executor.reset();
}

std::vector<CallbackGroup::SharedPtr> Executor::groups()
{
  std::vector<CallbackGroup::SharedPtr> found;
  for (const auto & weak : nodes_) {
    if (const auto node = weak.lock()) {
      node->for_each_callback_group(
        [&](const CallbackGroup::SharedPtr & group) {
          if (group->automatically_add_to_executor_with_node() && group->sitaf_executor.expired()) {
            found.push_back(group);
          }
        });
    }
  }
  for (const auto & weak : added_groups_) {
    if (const auto group = weak.lock()) {
      found.push_back(group);
    }
  }
  return found;
}

std::vector<std::weak_ptr<CallbackGroup>> Executor::get_all_callback_groups()
{
  const auto all = groups();
  return {all.begin(), all.end()};
}

bool Executor::next(AnyExecutable & found)
{
  struct Ready
  {
    std::pair<int, std::int64_t> order;
    std::shared_ptr<sitaf_ros::Entity> entity;
    CallbackGroup::SharedPtr group;
  };
  std::vector<Ready> ready;
  for (const auto & group : groups()) {
    if (!group->can_be_taken_from()) {
      continue;
    }
    for (auto & entity : group->sitaf_entities()) {
      if (entity->in_wait_set) {
        continue;
      }
      if (const auto order = entity->order()) {
        ready.push_back({*order, std::move(entity), group});
      }
    }
  }
  std::stable_sort(ready.begin(), ready.end(), [](const Ready & a, const Ready & b) {return a.order < b.order;});
  auto & settings = sitaf_ros::Case::get();
  while (!ready.empty()) {
    const bool varied = settings.callback_order > 0 && ready.size() > 1;
    const std::size_t at = varied ? settings.random(ready.size()) : 0;
    Ready chosen = std::move(ready[at]);
    ready.erase(ready.begin() + static_cast<std::ptrdiff_t>(at));
    if (!chosen.group->sitaf_begins()) {
      continue;
    }
    auto run = chosen.entity->take();
    if (!run) {
      chosen.group->sitaf_ends();
      continue;
    }
    found = {std::move(chosen.entity), std::move(chosen.group), std::move(run)};
    return true;
  }
  return false;
}

void Executor::execute(AnyExecutable & found)
{
  kernel::count_callback();
  auto & callbacks = sitaf_ros::Unobserved::get().callbacks;
  const auto counted = callbacks.find(found.entity->callback_name);
  if (counted != callbacks.end()) {
    ++counted->second;
  }
  kernel::running(found.entity->callback_name);
  try {
    found.run();
    kernel::running("");
  } catch (...) {
    found.group->sitaf_ends();
    kernel::failed(found.entity->callback_name, kernel::current_exception_text());
    throw;
  }
  found.group->sitaf_ends();
}

bool Executor::goes_on() const {return context_->is_valid() && !canceled_ && !kernel::ending();}

std::optional<Nanos> Executor::next_due()
{
  std::optional<Nanos> first;
  for (const auto & group : groups()) {
    for (const auto & entity : group->sitaf_entities()) {
      const auto due = entity->due();
      if (due && *due > kernel::now() && (!first || *due < *first)) {
        first = due;
      }
    }
  }
  return first;
}

bool Executor::run_one(std::optional<Nanos> until)
{
  while (goes_on()) {
    AnyExecutable found;
    if (next(found)) {
      execute(found);
      return true;
    }
    if (until && *until <= kernel::now()) {
      return false;
    }
    auto deadline = next_due();
    if (until && (!deadline || *until < *deadline)) {
      deadline = until;
    }
    kernel::wait(sitaf_ros::work(), deadline, true);
  }
  return false;
}

namespace {

struct Spinning
{
  explicit Spinning(int & count)
  : count_(count) {++count_;}
  ~Spinning() {--count_;}
  int & count_;
};

}  // namespace

void Executor::spin()
{
  if (spinning_ > 0) {
    throw std::runtime_error("spin() called while already spinning");
  }
  Spinning spinning(spinning_);
  canceled_ = false;
  while (goes_on()) {
    run_one(std::nullopt);
  }
}

void Executor::spin_some(std::chrono::nanoseconds most)
{
  Spinning spinning(spinning_);
  canceled_ = false;
  const Nanos begun = kernel::now();
  bool any = false;
  AnyExecutable found;
  while (goes_on() && (most.count() == 0 || kernel::now() - begun < most.count()) && next(found)) {
    execute(found);
    found = {};
    any = true;
  }
  if (!any) {
    kernel::look();
  }
}

void Executor::spin_once_for(Nanos nanos)
{
  Spinning spinning(spinning_);
  canceled_ = false;
  const bool any =
    run_one(nanos < 0 ? std::nullopt : std::optional<Nanos>(kernel::now() + nanos));
  if (!any && nanos == 0) {
    kernel::look();
  }
}

FutureReturnCode Executor::spin_until(const std::function<bool()> & done, Nanos nanos)
{
  if (done()) {
    return FutureReturnCode::SUCCESS;
  }
  Spinning spinning(spinning_);
  canceled_ = false;
  const std::optional<Nanos> until =
    nanos < 0 ? std::nullopt : std::optional<Nanos>(kernel::now() + nanos);
  while (goes_on()) {
    AnyExecutable found;
    if (next(found)) {
      execute(found);
    } else if (until && kernel::now() >= *until) {
      return FutureReturnCode::TIMEOUT;
    } else {
      auto deadline = next_due();
      if (until && (!deadline || *until < *deadline)) {
        deadline = until;
      }
      kernel::wait(sitaf_ros::work(), deadline, true);
    }
    if (done()) {
      return FutureReturnCode::SUCCESS;
    }
  }
  return FutureReturnCode::INTERRUPTED;
}

void Executor::cancel()
{
  canceled_ = true;
  sitaf_ros::work_appeared();
}

void executors::MultiThreadedExecutor::spin()
{
  if (spinning_ > 0) {
    throw std::runtime_error("spin() called while already spinning");
  }
  Spinning spinning(spinning_);
  canceled_ = false;
  std::vector<std::uint64_t> threads;
  for (std::size_t i = 1; i < threads_; ++i) {
    threads.push_back(
      kernel::start(
        "a thread of the executor", [this] {
          while (goes_on()) {
            run_one(std::nullopt);
          }
        }));
  }
  while (goes_on()) {
    run_one(std::nullopt);
  }
  for (const auto thread : threads) {
    kernel::join(thread);
  }
}

}  // namespace rclcpp
