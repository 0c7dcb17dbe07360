// Names of topics, services and nodes: validation, expansion and remapping.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace sitaf_ros {

using Rules = std::vector<std::pair<std::string, std::string>>;

/// What is wrong with a name; empty if nothing is.
std::string topic_problem(const std::string & name);
std::string node_problem(const std::string & name);
std::string expand(const std::string & name, const std::string & node, const std::string & name_space);
std::string remapped(
  const std::string & name, const Rules & rules, const std::string & node, const std::string & name_space);
/// The value of `__node` or `__ns`, for all nodes or the named one; empty if there is none.
std::string special(const std::string & key, const Rules & rules, const std::string & node);
/// The rules `from:=to` in arguments.
Rules rules_of(const std::vector<std::string> & arguments);

}  // namespace sitaf_ros
