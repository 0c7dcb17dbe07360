#pragma once

#include <chrono>
#include <csignal>
#include <functional>
#include <iostream>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "rclcpp/executor.hpp"
#include "rclcpp/logging.hpp"
#include "rclcpp/parameter_client.hpp"
#include "rclcpp/rate.hpp"
#include "rclcpp/wait_set.hpp"
