#pragma once

#include "sitaf/runtime/test_run.hpp"

namespace sitaf::harness::getinfrareddata {

/// Simulation control (SC): sets up the virtual environment world/ir.world.yaml.
class SimulationControl {
 public:
  explicit SimulationControl(runtime::TestRun& run);

  /// Resets the world, sets the parameters of a case, and lets the world settle.
  ///
  /// - distance: Distance in m, from -1.0 to 20.0
  void prepare(double distance);

 private:
  simulation::Simulation& simulation_;
  suite::Upcoming& upcoming_;
};

}  // namespace sitaf::harness::getinfrareddata
