#pragma once

#include "sitaf/runtime/test_run.hpp"

namespace sitaf::harness::getinfrareddata {

/// Simulation control (SC): sets the virtual environment that world/ir.world.yaml describes.
class SimulationControl {
 public:
  explicit SimulationControl(runtime::TestRun& run);

  /// Puts the world into the state of a case, from a clean reset, and lets it settle.
  ///
  /// - distance: Distance in m, from -1.0 to 20.0
  void prepare(double distance);

 private:
  simulation::Simulation& simulation_;
  suite::Upcoming& upcoming_;
};

}  // namespace sitaf::harness::getinfrareddata
