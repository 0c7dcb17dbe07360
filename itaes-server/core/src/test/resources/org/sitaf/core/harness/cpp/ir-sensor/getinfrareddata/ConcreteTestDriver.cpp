#include "TestDriver.hpp"

namespace sitaf::harness::getinfrareddata {

/// Concrete test driver of InfraredSensorService.GetInfraredData. You may edit this class.
///
/// To keep your changes, save this file in the activity as
/// harness/GetInfraredData/ConcreteTestDriver.cpp. It then replaces the generated file.
class ConcreteTestDriver final : public TestDriver {
 public:
  using TestDriver::TestDriver;

 protected:
  /// Creates and sets up the component.
  std::unique_ptr<Component> createComponent() override {
    std::unique_ptr<Component> component = newComponent();
    runtime::setProperty(*component, "Size", "7", SITAF_SETTER(setSize));
    begin(*component);
    component->Enable();
    return component;
  }

  /// Runs before each call, after the world and the stub are prepared.
  void beforeCase(Component& /*component*/, const suite::TestCase& /*testCase*/) override {}

  /// Runs after each call, before its result is compared.
  void afterCase(Component& /*component*/, const suite::TestCase& /*testCase*/) override {}

  /// Calls the method under test. Only this call is timed.
  double call(Component& component, std::int32_t indexOfSensor, std::int32_t numOfSensor) override {
    return component.GetInfraredData(indexOfSensor, numOfSensor);
  }
};

}  // namespace sitaf::harness::getinfrareddata

int main(int argc, char** argv) {
  return sitaf::runtime::start<sitaf::harness::getinfrareddata::ConcreteTestDriver>(argc, argv);
}
