#include "SimulationControl.hpp"

#include <chrono>

namespace sitaf::harness::getinfrareddata {
namespace {

/// Simulation time before the call.
constexpr std::chrono::nanoseconds settleTime = std::chrono::milliseconds(0);

}  // namespace

SimulationControl::SimulationControl(runtime::TestRun& run)
    : simulation_(run.simulation()), upcoming_(run.upcoming()) {}

void SimulationControl::prepare(double distance) {
  simulation_.prepareAhead({"Distance"}, {distance}, settleTime, upcoming_);
}

}  // namespace sitaf::harness::getinfrareddata
