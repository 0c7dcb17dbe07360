#pragma once

#include <string>

#include "sitaf/sim/v1/simulation.pb.h"

namespace sitaf::simulation {

/// Packs a world description and all files of its folder, so that the simulator never opens a path of its host. Symbolic links are passed
/// over. A folder that cannot be read, or holds more than a world can have, is a std::runtime_error.
sim::v1::WorldSource readWorld(const std::string& description);

}  // namespace sitaf::simulation
