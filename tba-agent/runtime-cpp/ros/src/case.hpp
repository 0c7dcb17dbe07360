// The settings of a case, and what the node reports to the test driver.
#pragma once

#include <deque>
#include <string>
#include <utility>
#include <vector>

#include "sitaf_ros/graph.hpp"

namespace sitaf_ros {

enum class EventKind {MESSAGE = 1, REQUEST = 2, RESPONSE = 3, OVERRIDES = 4, LOG = 5};

/// What the driver takes after the node has run.
struct Event
{
  EventKind kind;
  std::int64_t id = 0;
  std::int64_t number = 0;
  Nanos time = 0;
  std::string text{};
  Bytes bytes{};
};

struct Case
{
  static Case & get();

  std::vector<std::pair<std::string, std::string>> remap;
  std::int64_t callback_order = 0;
  bool use_sim_time = false;
  std::string node_name;
  std::deque<Event> events;
  /// The answer to the event OVERRIDES.
  Bytes overrides;
  bool has_overrides = false;

  std::uint64_t random(std::uint64_t below);

private:
  std::uint64_t state_ = 0;
};

}  // namespace sitaf_ros
