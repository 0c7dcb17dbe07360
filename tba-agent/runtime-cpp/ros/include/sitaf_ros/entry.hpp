// The generated translation unit of a node defines what each case runs.
#pragma once

namespace sitaf_ros {

void run_entry();

}  // namespace sitaf_ros
