#pragma once

#include "rclcpp/client.hpp"
