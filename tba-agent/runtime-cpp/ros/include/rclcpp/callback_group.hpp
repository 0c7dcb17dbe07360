// What an executor runs, and the groups of it.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "rclcpp/macros.hpp"
#include "sitaf_ros/graph.hpp"

namespace sitaf_ros {

/// Anything that an executor runs callbacks for.
class Entity : public std::enable_shared_from_this<Entity>
{
public:
  virtual ~Entity() = default;

  /// The place in the order of what is ready: messages by their number, then timers; empty if it is not ready.
  virtual std::optional<std::pair<int, std::int64_t>> order() {return std::nullopt;}
  /// When it will be ready; empty for never, or for what only others can tell.
  virtual std::optional<Nanos> due() {return std::nullopt;}
  /// What to run; empty if it is no longer ready.
  virtual std::function<void()> take() {return {};}

  void name_callback(const std::string & name)
  {
    callback_name = name;
    Unobserved::get().callbacks.emplace(name, 0);
  }

  std::string callback_name;
  bool in_wait_set = false;
};

}  // namespace sitaf_ros

namespace rclcpp {

enum class CallbackGroupType {MutuallyExclusive, Reentrant};

using Waitable = sitaf_ros::Entity;

class CallbackGroup
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(CallbackGroup)

  explicit CallbackGroup(CallbackGroupType type, bool automatic = true)
  : type_(type), automatic_(automatic) {}

  CallbackGroupType type() const {return type_;}
  bool automatically_add_to_executor_with_node() const {return automatic_;}
  bool & can_be_taken_from() {return free_;}
  std::size_t size() const {return entities_.size();}

  void sitaf_add(const std::shared_ptr<sitaf_ros::Entity> & entity);
  /// Those that still exist, in the order of creation.
  std::vector<std::shared_ptr<sitaf_ros::Entity>> sitaf_entities();

  bool sitaf_begins();
  void sitaf_ends();
  std::weak_ptr<void> sitaf_executor;

private:
  CallbackGroupType type_;
  bool automatic_;
  bool free_ = true;
  std::vector<std::weak_ptr<sitaf_ros::Entity>> entities_;
};

namespace callback_group {

using CallbackGroupType = rclcpp::CallbackGroupType;

}  // namespace callback_group
}  // namespace rclcpp
