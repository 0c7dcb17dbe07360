// Runs the entry of a node with an installed ROS 2, for the process that has loaded its library.
#pragma once

#include <exception>
#include <string>

#include "sitaf_ros/arguments.hpp"
#include "sitaf_ros/entry.hpp"

/// Runs to the end of the node; returns what it threw, or an empty text.
extern "C" const char * sitaf_node_run(int count, char ** arguments)
{
  static std::string thrown;
  sitaf_ros::argument_count() = count;
  sitaf_ros::arguments() = arguments;
  try {
    sitaf_ros::run_entry();
    thrown.clear();
  } catch (const std::exception & e) {
    thrown = std::string(e.what()).empty() ? "an exception without a text" : e.what();
  } catch (...) {
    thrown = "an object that is no std::exception";
  }
  return thrown.c_str();
}
