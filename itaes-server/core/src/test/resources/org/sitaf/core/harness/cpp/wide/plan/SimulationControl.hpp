#pragma once

#include <functional>
#include <string>

#include "sitaf/runtime/test_run.hpp"

namespace sitaf::harness::plan {

/// Simulation control (SC): sets the virtual environment that w.world.yaml describes.
class SimulationControl {
 public:
  explicit SimulationControl(runtime::TestRun& run);

  /// Puts the world into the state of a case, from a clean reset.
  ///
  /// - distance: Distance in m, from 0.0 to 5.0
  void prepare(double distance);

  /// Lets time pass before the call; from now on the component is executed once a period.
  void settle(const std::function<void()>& execute);

  /// Lets time pass after the call.
  void runOn();

  /// What the world shows, in its own unit.
  double observe(const std::string& name) const;

 private:
  simulation::Simulation& simulation_;
};

}  // namespace sitaf::harness::plan
