#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "SimulationControl.hpp"
#include "TestStub.hpp"
#include "planner.hpp"
#include "sitaf/interfaces/Path.hpp"
#include "sitaf/interfaces/Point.hpp"
#include "sitaf/runtime/suite_driver.hpp"

namespace sitaf::harness::plan {

/// The class under test.
using Component = ::Planner;

/// Test driver (TD) of Planner.Plan: runs the cases of the test model Plan.
class TestDriver : public runtime::SuiteDriver<Component> {
 public:
  explicit TestDriver(runtime::TestRun& run);

 protected:
  /// Calls the method under test, Planner.Plan. Only this call is timed.
  virtual interfaces::Path call(Component& component, const interfaces::Point& goal,
                                const std::vector<double>& weights, bool& found,
                                std::int32_t& budget) = 0;

  /// Creates the component. Passes the hardware and stubs that its constructor requires.
  std::unique_ptr<Component> newComponent();

  void runCase(const suite::TestCase& testCase, suite::CaseResult& result) final;

 private:
  SimulationControl simulationControl_;
  TestStub testStub_;
};

}  // namespace sitaf::harness::plan
