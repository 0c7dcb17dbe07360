// The driver's side of the kernel.
#pragma once

#include "sitaf_ros/kernel.hpp"

namespace sitaf_ros::kernel {

void set_now(Nanos time);
/// Runs threads until all wait.
void run_ready();
/// When the first wait ends; -1 for never.
Nanos next_deadline();
/// Sets the time and makes the threads ready whose waits end by then.
void advance_to(Nanos time);
/// Ends all waits and runs what the node does then.
void end();
/// `where`, a tab and `what` of the first failure; empty if there is none.
const std::string & failure();
/// What the node does, also for the process that waits for this one; empty between callbacks.
const char * running();
bool looked_too_often();
bool called_back_too_often();

}  // namespace sitaf_ros::kernel
