#pragma once

#include <csignal>
#include <iostream>

#include "rclcpp/executor.hpp"
#include "rclcpp/logging.hpp"
#include "rclcpp/parameter_client.hpp"
#include "rclcpp/rate.hpp"
#include "rclcpp/wait_set.hpp"
