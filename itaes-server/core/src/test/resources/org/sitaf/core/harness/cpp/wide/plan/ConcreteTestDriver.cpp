#include <cstdint>

#include "TestDriver.hpp"
#include "sitaf/interfaces/Mode.hpp"

namespace sitaf::harness::plan {

/// Concrete test driver of Planner.Plan. You may edit this class.
///
/// To keep your changes, save this file in the activity as harness/Plan/ConcreteTestDriver.cpp. It
/// then replaces the generated file.
class ConcreteTestDriver final : public TestDriver {
 public:
  using TestDriver::TestDriver;

 protected:
  /// Creates and sets up the component.
  std::unique_ptr<Component> createComponent() override {
    std::unique_ptr<Component> component = newComponent();
    runtime::setProperty(*component, "Gain", "0.5", SITAF_SETTER(setGain));
    runtime::setProperty(*component, "odd name", "x", runtime::NoSetter{});
    begin(*component);
    component->SetMode(interfaces::Mode::FAST);
    component->SetLimit(std::int32_t{-2147483647 - 1});
    return component;
  }

  /// Runs before each call, after the world and the stub are prepared.
  void beforeCase(Component& /*component*/, const suite::TestCase& /*testCase*/) override {}

  /// Runs after each call, before its result is compared.
  void afterCase(Component& /*component*/, const suite::TestCase& /*testCase*/) override {}

  /// Calls the method under test. Only this call is timed.
  interfaces::Path call(Component& component, const interfaces::Point& goal,
                        const std::vector<double>& weights, bool& found,
                        std::int32_t& budget) override {
    return component.Plan(goal, weights, found, budget);
  }
};

}  // namespace sitaf::harness::plan

int main(int argc, char** argv) {
  return sitaf::runtime::start<sitaf::harness::plan::ConcreteTestDriver>(argc, argv);
}
