#pragma once

#include "rclcpp/publisher_options.hpp"
