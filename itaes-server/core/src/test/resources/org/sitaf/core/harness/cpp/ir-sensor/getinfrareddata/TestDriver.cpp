#include "TestDriver.hpp"

namespace sitaf::harness::getinfrareddata {

TestDriver::TestDriver(runtime::TestRun& run)
    : SuiteDriver(run, runtime::LifeCycle::perCase), simulationControl_(run), testStub_(run) {}

std::unique_ptr<Component> TestDriver::newComponent() {
  return runtime::createComponent<Component>(*run().hardware());
}

void TestDriver::runCase(const suite::TestCase& testCase, suite::CaseResult& result) {
  // 1. Read the test case.
  const auto indexOfSensor = testCase.value<std::int32_t>("IndexOfSensor");
  const auto numOfSensor = testCase.value<std::int32_t>("NumOfSensor");
  const auto distance = testCase.value<double>("Distance");

  // 2. The simulation control sets up the virtual environment (TDSD).
  simulationControl_.prepare(distance);

  // 3. The test stub gets the answers of the required interfaces (TDTS).
  testStub_.prepare();

  // 4. The component is called with the input (TDI). The call is timed.
  Component& component = this->component();
  beforeCase(component, testCase);
  stopwatch().start();
  const double returned = call(component, indexOfSensor, numOfSensor);
  stopwatch().stop();
  afterCase(component, testCase);

  // 5. The outputs are recorded and saved.
  result.record("return", returned);
  save(result);
}

}  // namespace sitaf::harness::getinfrareddata
