#include "SimulationControl.hpp"

#include <chrono>

namespace sitaf::harness::plan {
namespace {

/// Simulation time before the call.
constexpr std::chrono::nanoseconds settleTime = std::chrono::milliseconds(100);

/// Simulation time after the call.
constexpr std::chrono::nanoseconds runTime = std::chrono::milliseconds(250);

/// Simulation time between two executions of the component.
constexpr std::chrono::nanoseconds period = std::chrono::milliseconds(10);

}  // namespace

SimulationControl::SimulationControl(runtime::TestRun& run) : simulation_(run.simulation()) {}

void SimulationControl::prepare(double distance) {
  simulation_.prepare({"Distance"}, {distance}, std::chrono::nanoseconds(0), settleTime);
}

void SimulationControl::settle(const std::function<void()>& execute) {
  simulation_.every(period, execute);
  simulation_.advance(settleTime);
}

void SimulationControl::runOn() { simulation_.advance(runTime); }

double SimulationControl::observe(const std::string& name) const {
  return simulation_.observation(name);
}

}  // namespace sitaf::harness::plan
