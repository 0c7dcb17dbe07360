#pragma once

#include <functional>
#include <string>

#include "sitaf/runtime/test_run.hpp"

namespace sitaf::harness::plan {

/// Simulation control (SC): sets up the virtual environment w.world.yaml.
class SimulationControl {
 public:
  explicit SimulationControl(runtime::TestRun& run);

  /// Resets the world and sets the parameters of a case.
  ///
  /// - distance: Distance in m, from 0.0 to 5.0
  void prepare(double distance);

  /// Lets the world settle. From now on, the component is executed periodically.
  void settle(const std::function<void()>& execute);

  /// Advances the simulation time after the call.
  void runOn();

  /// Returns an observation of the world in its unit.
  double observe(const std::string& name) const;

 private:
  simulation::Simulation& simulation_;
};

}  // namespace sitaf::harness::plan
