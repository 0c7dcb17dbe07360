#include "TestDriver.hpp"

namespace sitaf::harness::plan {

TestDriver::TestDriver(runtime::TestRun& run)
    : SuiteDriver(run, runtime::LifeCycle::perCase), simulationControl_(run), testStub_(run) {}

std::unique_ptr<Component> TestDriver::newComponent() {
  return runtime::createComponent<Component>(*run().hardware(), testStub_.rangeFinder());
}

void TestDriver::runCase(const suite::TestCase& testCase, suite::CaseResult& result) {
  // 1. Read the test case.
  interfaces::Point goal{};
  goal.x = testCase.value<double>("goal.x");
  std::vector<double> weights{};
  weights.resize(2);
  weights[1] = testCase.value<double>("weights[1]");
  bool found{};
  std::int32_t budget{};
  budget = testCase.value<std::int32_t>("budget");
  const auto distance = testCase.value<double>("Distance");
  const auto rangeFinderRange = runtime::answer<double>(testCase, "RangeFinder.Range");
  const auto rangeFinderRange2 = runtime::answer<double>(testCase, "RangeFinder.Range#2");
  const auto rangeFinderRangeQuality =
      runtime::answer<double>(testCase, "RangeFinder.Range.quality");

  // 2. The simulation control sets up the virtual environment (TDSD).
  simulationControl_.prepare(distance);

  // 3. The test stub gets the answers of the required interfaces (TDTS).
  testStub_.prepare(rangeFinderRange, rangeFinderRange2, rangeFinderRangeQuality);

  // 4. The component is called with the input (TDI). The call is timed.
  Component& component = this->component();
  simulationControl_.settle([this, &component] { execute(component); });
  beforeCase(component, testCase);
  stopwatch().start();
  const interfaces::Path returned = call(component, goal, weights, found, budget);
  stopwatch().stop();
  simulationControl_.runOn();
  afterCase(component, testCase);

  // 5. The outputs are recorded and saved.
  result.record("return", returned);
  result.record("found", found);
  result.record("budget", budget);
  result.recordPart("return.points[0].x", [&] { return returned.points.at(0).x; });
  result.record("robot_x", simulationControl_.observe("robot_x"));
  save(result);
}

}  // namespace sitaf::harness::plan
