#pragma once

// The generated unit of a test names the class, so there is nothing to register.
#define RCLCPP_COMPONENTS_REGISTER_NODE(NodeClass) static_assert(sizeof(NodeClass) > 0);
