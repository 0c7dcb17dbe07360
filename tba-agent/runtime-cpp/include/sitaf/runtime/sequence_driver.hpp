#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <utility>

#include "sitaf/runtime/suite_driver.hpp"

namespace sitaf::runtime {

/// The steps of a test driver: each of them is a call of the component or an event of its world.
class Sequence {
 public:
  virtual ~Sequence() = default;
  Sequence(const Sequence&) = delete;
  Sequence& operator=(const Sequence&) = delete;

  /// Executes a step: makes its call and records its outputs, or sets what its event sets.
  virtual void runStep(const suite::TestStep& step, suite::CaseResult& result) = 0;

  /// Whether the next step begins while this one runs.
  virtual bool overlaps(const suite::TestStep& /*step*/) const { return false; }

  /// How many overlapping steps run at once at most.
  virtual std::size_t atOnce() const { return std::numeric_limits<std::size_t>::max(); }

 protected:
  Sequence() = default;
};

/// Base class of the generated test drivers of sequences: a case is a list of steps.
template <class Component>
class SequenceDriver : public SuiteDriver<Component>, public Sequence {
 protected:
  /// Creates the driver of a run; see SuiteDriver.
  SequenceDriver(TestRun& run, LifeCycle lifeCycle, NotHooks notHooks = {}) : SuiteDriver<Component>(run, lifeCycle, std::move(notHooks)) {}

  /// Sets up the world, the stubs and the component of a case.
  virtual void beginSequence(const suite::TestCase& testCase) = 0;

  /// Lets the time after the last step pass.
  virtual void endSequence(const suite::TestCase& testCase) = 0;

  void runCase(const suite::TestCase& testCase, suite::CaseResult& result) final {
    current_ = &testCase;
    beginSequence(testCase);
    if (this->run().runSteps(*this, testCase.steps())) {
      this->run().endSteps();
      endSequence(testCase);
    }
    this->saveSequence(result);
  }

  /// The case that is executed, whose initial values may be properties of the component.
  const suite::TestCase& currentCase() const { return *current_; }

  /// Throws the exception for a step that this driver does not know.
  [[noreturn]] static void unknown(const suite::TestStep& step) {
    throw suite::CaseDataError("the test driver has no step '" + step.name() + "': generate the test application again");
  }

 private:
  const suite::TestCase* current_ = nullptr;
};

}  // namespace sitaf::runtime
