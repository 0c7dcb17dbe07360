#pragma once

#include <string>

#include "sitaf/sim/v1/simulation.pb.h"

namespace sitaf::simulation {

/// Reads a world description and all files of its folder into a request, so that the simulator never opens files of its host. Symbolic
/// links are ignored. A folder that cannot be read, or exceeds the limits of a world, throws std::runtime_error.
sim::v1::WorldSource readWorld(const std::string& description);

}  // namespace sitaf::simulation
