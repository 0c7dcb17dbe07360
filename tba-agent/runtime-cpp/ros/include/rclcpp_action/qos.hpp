#pragma once

#include "rclcpp_action/rclcpp_action.hpp"
