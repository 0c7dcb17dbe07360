#include <cstdint>

#include "TestDriver.hpp"
#include "sitaf/interfaces/Mode.hpp"

namespace sitaf::harness::plan {

/// Concrete test driver: what is particular about testing Planner.Plan, to be changed freely.
///
/// Keep a changed version in the activity as harness/Plan/ConcreteTestDriver.cpp: it is used from
/// then on, and never generated over.
class ConcreteTestDriver final : public TestDriver {
 public:
  using TestDriver::TestDriver;

 protected:
  /// Makes the component and sets it up.
  std::unique_ptr<Component> createComponent() override {
    std::unique_ptr<Component> component = newComponent();
    runtime::setProperty(*component, "Gain", "0.5", SITAF_SETTER(setGain));
    runtime::setProperty(*component, "odd name", "x", runtime::NoSetter{});
    begin(*component);
    component->SetMode(interfaces::Mode::FAST);
    component->SetLimit(std::int32_t{-2147483647 - 1});
    return component;
  }

  /// Runs before each call, when the world and the stub are set.
  void beforeCase(Component& /*component*/, const suite::TestCase& /*testCase*/) override {}

  /// Runs after each call, before its result is judged.
  void afterCase(Component& /*component*/, const suite::TestCase& /*testCase*/) override {}

  /// The call under test; nothing else is timed.
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
