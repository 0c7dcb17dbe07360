#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "sitaf/runtime/component.hpp"
#include "sitaf/runtime/nonblocking_call.hpp"
#include "sitaf/runtime/test_run.hpp"
#include "sitaf/suite/literals.hpp"
#include "sitaf/suite/value.hpp"

namespace sitaf::runtime {

/// How long an instance of the component under test is used.
enum class LifeCycle {
  /// A new instance for each case.
  perCase,
  /// One instance for all cases of a process.
  suite
};

/// The interface of a test driver for its run.
class Driver {
 public:
  virtual ~Driver() = default;
  Driver(const Driver&) = delete;
  Driver& operator=(const Driver&) = delete;

  /// Runs a case and returns whether its result was saved.
  bool runAndSave(const suite::TestCase& testCase, suite::CaseResult& result);

  /// Whether the result of the current case was saved.
  bool isSaved() const { return saved_; }

  /// Stops and destroys the component if it is created for each case.
  virtual void endCase() = 0;

  /// Stops and destroys the component.
  virtual void close() = 0;

 protected:
  explicit Driver(TestRun& run) : run_(run) {}

  /// Runs one case and saves its result, in the five steps of Fig. 10.
  virtual void runCase(const suite::TestCase& testCase, suite::CaseResult& result) = 0;

  /// Measures the call under test.
  Stopwatch& stopwatch() { return run_.stopwatch().ofThisThread(); }

  /// Writes the result of the case, with the time of its call, to the results file.
  void save(suite::CaseResult& result);

  /// Writes the end of a sequence, whose steps have their own times.
  void saveSequence(suite::CaseResult& result);

  TestRun& run() { return run_; }

  /// Records an output data port, or a part of it, whenever it changes in this case.
  template <class Read>
  void watch(std::string signal, Read read) {
    run_.watch(std::move(signal), [read]() -> std::string {
      try {
        return suite::literals::write(suite::valueOf(read()));
      } catch (const std::out_of_range&) {
        return "null";
      }
    });
  }

  /// Starts a nonblocking call; it is measured on its own thread.
  template <class Call>
  auto callNonblocking(Call call) {
    return NonblockingCall<decltype(call())>(run_.stopwatch(), run_.simulationIfAny(), std::move(call));
  }

 private:
  TestRun& run_;
  bool saved_ = false;
};

/// Base class of the generated test drivers: life cycle of the component and results.
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
  /// Creates the driver of a run; notHooks are methods of the component's interfaces, which are never called as hooks.
  SuiteDriver(TestRun& run, LifeCycle lifeCycle, NotHooks notHooks = {})
      : Driver(run), lifeCycle_(lifeCycle), notHooks_(std::move(notHooks)) {}

  /// Creates the component and sets its properties.
  virtual std::unique_ptr<Component> createComponent() = 0;

  /// Called before each call under test, after the world and the stubs are set up.
  virtual void beforeCase(Component& /*component*/, const suite::TestCase& /*testCase*/) {}

  /// Called after each call under test, before the result is saved.
  virtual void afterCase(Component& /*component*/, const suite::TestCase& /*testCase*/) {}

  /// The component of this case: a new one, or that of the previous case when one instance serves the whole suite.
  Component& component() {
    if (component_ == nullptr) {
      component_ = createComponent();
      begin(*component_);
    }
    return *component_;
  }

  /// Initialises and starts a component if its class has the methods. Further calls for the same component do nothing.
  void begin(Component& component) {
    if (begun_ != &component) {
      begun_ = &component;
      beginLife(component, notHooks_);
    }
  }

  /// Executes one period of a periodic component.
  void execute(Component& component) { runtime::execute(component, notHooks_); }

 private:
  LifeCycle lifeCycle_;
  NotHooks notHooks_;
  std::unique_ptr<Component> component_;
  const Component* begun_ = nullptr;
};

}  // namespace sitaf::runtime
