#pragma once

#include <memory>
#include <utility>

#include "sitaf/runtime/call_beside.hpp"
#include "sitaf/runtime/component.hpp"
#include "sitaf/runtime/test_run.hpp"

namespace sitaf::runtime {

/// When a component under test is made and destroyed.
enum class LifeCycle {
  /// Anew for each case.
  perCase,
  /// Once for all cases of a process.
  suite
};

/// What a run knows of a test driver.
class Driver {
 public:
  virtual ~Driver() = default;
  Driver(const Driver&) = delete;
  Driver& operator=(const Driver&) = delete;

  /// Runs a case and says whether it got as far as saving its result.
  bool runAndSave(const suite::TestCase& testCase, suite::CaseResult& result);

  /// Whether the result of the current case is in the file.
  bool isSaved() const { return saved_; }

  /// Ends the component's life where it lives for one case.
  virtual void endCase() = 0;

  /// Ends the component's life.
  virtual void close() = 0;

 protected:
  explicit Driver(TestRun& run) : run_(run) {}

  /// Runs one case and saves its result, in the five steps of Fig. 10.
  virtual void runCase(const suite::TestCase& testCase, suite::CaseResult& result) = 0;

  /// Measures the call under test.
  Stopwatch& stopwatch() { return run_.stopwatch(); }

  /// Hands the result of the case, with the time of its call, over to the results file.
  void save(suite::CaseResult& result);

  TestRun& run() { return run_; }

  /// Begins a nonblocking call; it is timed on its own thread.
  template <class Call>
  auto beside(Call call) {
    return CallBeside<decltype(call())>(run_.stopwatch(), run_.simulationIfAny(), std::move(call));
  }

 private:
  TestRun& run_;
  bool saved_ = false;
};

/// Base of the generated test drivers: life cycle of the component and results.
template <class Component>
class SuiteDriver : public Driver {
 public:
  void endCase() override {
    if (lifeCycle_ == LifeCycle::perCase) {
      close();
    }
  }

  void close() override {
    const std::unique_ptr<Component> last = std::move(component_);
    if (last != nullptr) {
      begun_ = nullptr;
      endLife(*last, notHooks_);
    }
  }

 protected:
  /// A driver within a run; notHooks are methods of the component's interfaces, which its life must not call.
  SuiteDriver(TestRun& run, LifeCycle lifeCycle, NotHooks notHooks = {})
      : Driver(run), lifeCycle_(lifeCycle), notHooks_(std::move(notHooks)) {}

  /// Makes the component and sets it up.
  virtual std::unique_ptr<Component> createComponent() = 0;

  /// Runs before each call, when the world and the stubs are set.
  virtual void beforeCase(Component& /*component*/, const suite::TestCase& /*testCase*/) {}

  /// Runs after each call, before the result is judged.
  virtual void afterCase(Component& /*component*/, const suite::TestCase& /*testCase*/) {}

  /// The component of this case: made now, or that of the case before where it lives as long as the suite.
  Component& component() {
    if (component_ == nullptr) {
      component_ = createComponent();
      begin(*component_);
    }
    return *component_;
  }

  /// Initialises and starts a component, where its class has methods named so. A component that begins its life twice does it once.
  void begin(Component& component) {
    if (begun_ != &component) {
      begun_ = &component;
      beginLife(component, notHooks_);
    }
  }

  /// Does the work of one period of a periodic component.
  void execute(Component& component) { runtime::execute(component, notHooks_); }

 private:
  LifeCycle lifeCycle_;
  NotHooks notHooks_;
  std::unique_ptr<Component> component_;
  const Component* begun_ = nullptr;
};

}  // namespace sitaf::runtime
