#include "TestDriver.hpp"

namespace sitaf::harness::getinfrareddata {

/// Concrete test driver: what is particular about testing InfraredSensorService.GetInfraredData, to
/// be changed freely.
///
/// Keep a changed version in the activity as harness/GetInfraredData/ConcreteTestDriver.cpp: it is
/// used from then on, and never generated over.
class ConcreteTestDriver final : public TestDriver {
 public:
  using TestDriver::TestDriver;

 protected:
  /// Makes the component and sets it up.
  std::unique_ptr<Component> createComponent() override {
    std::unique_ptr<Component> component = newComponent();
    runtime::setProperty(*component, "Size", "7", SITAF_SETTER(setSize));
    begin(*component);
    component->Enable();
    return component;
  }

  /// Runs before each call, when the world and the stub are set.
  void beforeCase(Component& /*component*/, const suite::TestCase& /*testCase*/) override {}

  /// Runs after each call, before its result is judged.
  void afterCase(Component& /*component*/, const suite::TestCase& /*testCase*/) override {}

  /// The call under test; nothing else is timed.
  double call(Component& component, std::int32_t indexOfSensor, std::int32_t numOfSensor) override {
    return component.GetInfraredData(indexOfSensor, numOfSensor);
  }
};

}  // namespace sitaf::harness::getinfrareddata

int main(int argc, char** argv) {
  return sitaf::runtime::start<sitaf::harness::getinfrareddata::ConcreteTestDriver>(argc, argv);
}
