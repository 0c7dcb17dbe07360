#pragma once

#include <cstdint>
#include <memory>

#include "SimulationControl.hpp"
#include "TestStub.hpp"
#include "infrared_sensor.hpp"
#include "sitaf/runtime/suite_driver.hpp"

namespace sitaf::harness::getinfrareddata {

/// The class under test.
using Component = ::robot::InfraredSensor;

/// Test driver (TD) of InfraredSensorService.GetInfraredData: runs the cases of the test model
/// GetInfraredData.
///
/// Distance to the obstacle, as infrared sensor IndexOfSensor sees it
class TestDriver : public runtime::SuiteDriver<Component> {
 public:
  explicit TestDriver(runtime::TestRun& run);

 protected:
  /// Calls the method under test, InfraredSensorService.GetInfraredData. Only this call is timed.
  virtual double call(Component& component, std::int32_t indexOfSensor,
                      std::int32_t numOfSensor) = 0;

  /// Creates the component. Passes the hardware and stubs that its constructor requires.
  std::unique_ptr<Component> newComponent();

  void runCase(const suite::TestCase& testCase, suite::CaseResult& result) final;

 private:
  SimulationControl simulationControl_;
  TestStub testStub_;
};

}  // namespace sitaf::harness::getinfrareddata
