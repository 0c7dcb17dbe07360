#include "names.hpp"

#include <cctype>

#include "rclcpp/exceptions.hpp"

namespace sitaf_ros {

std::string topic_problem(const std::string & name)
{
  if (name.empty()) {
    return "topic name must not be empty string";
  }
  if (name.size() > 1 && name.back() == '/') {
    return "topic name must not end with a forward slash";
  }
  if (name.find("//") != std::string::npos) {
    return "topic name must not contain repeated '/'";
  }
  if (name.find('~', 1) != std::string::npos || (name[0] == '~' && name.size() > 1 && name[1] != '/')) {
    return "topic name has tilde in invalid location, it may only be first and followed by '/'";
  }
  char before = '/';
  for (const char c : name) {
    if (!std::isalnum(static_cast<unsigned char>(c)) && std::string("_/~{}").find(c) == std::string::npos) {
      return std::string("topic name must contain only alphanumerics, '_', '~', '{', or '}', not '") + c + "'";
    }
    if (before == '/' && std::isdigit(static_cast<unsigned char>(c))) {
      return "topic name token must not start with a number";
    }
    before = c;
  }
  return "";
}

std::string node_problem(const std::string & name)
{
  if (name.empty()) {
    return "node name must not be empty";
  }
  for (const char c : name) {
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '_') {
      return "node name must not contain characters other than alphanumerics or '_'";
    }
  }
  return std::isdigit(static_cast<unsigned char>(name[0])) ? "node name must not start with a number" : "";
}

namespace {

void replace(std::string & text, const std::string & what, const std::string & by)
{
  for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size())) {
    text.replace(at, what.size(), by);
  }
}

}  // namespace

std::string expand(const std::string & given, const std::string & node, const std::string & name_space)
{
  const std::string problem = topic_problem(given);
  if (!problem.empty()) {
    throw rclcpp::exceptions::InvalidTopicNameError(given, problem);
  }
  const std::string base = name_space == "/" ? "" : name_space;
  std::string name = given;
  replace(name, "{node}", node);
  replace(name, "{ns}", base.empty() ? "/" : base);
  replace(name, "{namespace}", base.empty() ? "/" : base);
  if (name[0] == '~') {
    return base + "/" + node + name.substr(1);
  }
  return name[0] == '/' ? name : base + "/" + name;
}

std::string remapped(
  const std::string & name, const Rules & rules, const std::string & node, const std::string & name_space)
{
  const std::string full = expand(name, node, name_space);
  for (const auto & [source, target] : rules) {
    const auto colon = source.rfind(':');
    const std::string only = colon == std::string::npos ? "" : source.substr(0, colon);
    const std::string pattern = colon == std::string::npos ? source : source.substr(colon + 1);
    if ((!only.empty() && only != "rostopic" && only != "rosservice" && only != node) || pattern.rfind("__", 0) == 0) {
      continue;
    }
    if (expand(pattern, node, name_space) == full) {
      return expand(target, node, name_space);
    }
  }
  return full;
}

std::string special(const std::string & key, const Rules & rules, const std::string & node)
{
  for (const std::string & wanted : {node + ":" + key, key}) {
    for (const auto & [source, target] : rules) {
      if (source == wanted) {
        return target;
      }
    }
  }
  return "";
}

Rules rules_of(const std::vector<std::string> & arguments)
{
  Rules rules;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const bool option = (arguments[i] == "-r" || arguments[i] == "--remap") && i + 1 < arguments.size();
    const std::string & rule = option ? arguments[++i] : arguments[i];
    const auto at = rule.find(":=");
    if (at != std::string::npos && (option || (i > 0 ? arguments[i - 1] != "-p" && arguments[i - 1] != "--param" : true))) {
      rules.emplace_back(rule.substr(0, at), rule.substr(at + 2));
    }
  }
  return rules;
}

}  // namespace sitaf_ros
