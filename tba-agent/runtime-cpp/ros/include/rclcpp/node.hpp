#pragma once

#include <memory>
#include <string>

#include "rclcpp/node_api.hpp"

namespace rclcpp {

class Node : public NodeApi, public std::enable_shared_from_this<Node>
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Node)

  explicit Node(const std::string & name, const NodeOptions & options = NodeOptions())
  : NodeApi(name, "", options) {}
  explicit Node(
    const std::string & name, const std::string & name_space, const NodeOptions & options = NodeOptions())
  : NodeApi(name, name_space, options) {}

  Node::SharedPtr create_sub_node(const std::string & sub)
  {
    const std::string & own = get_sub_namespace();
    return std::shared_ptr<Node>(new Node(core_, own.empty() ? sub : own + "/" + sub));
  }

protected:
  Node(std::shared_ptr<node_interfaces::NodeCore> core, const std::string & sub)
  : NodeApi(std::move(core), sub) {}
};

}  // namespace rclcpp
