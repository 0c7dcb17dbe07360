#pragma once

#include <atomic>
#include <exception>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "sitaf/runtime/sequence_driver.hpp"
#include "sitaf/runtime/stopwatch.hpp"
#include "sitaf/simulation/simulation.hpp"
#include "sitaf/suite/case_result.hpp"

namespace sitaf::runtime {

/// What a run does with a step.
class StepRunner {
 public:
  virtual ~StepRunner() = default;

  /// Notes in the record of a step when it begins.
  virtual void begins(suite::CaseResult& result) = 0;

  /// Executes a step in the calling thread, with the stopwatch of this thread. Returns the message when the case took too much simulation
  /// time. Throws when no further case can run.
  virtual std::string execute(Sequence& sequence, const suite::TestStep& step, suite::CaseResult& result) = 0;

  /// Moves the calls of stubs so far to the record of the step that began last.
  virtual void takeCalls(suite::CaseResult& result) = 0;

  /// Writes the record of a step that is complete.
  virtual void saveStep(suite::CaseResult& result) = 0;
};

/// Executes the steps of a case of which some overlap. An overlapping step has a thread of its own; the next step begins when its call
/// waits for simulation time or has ended, or at once without a simulation. Records are written in the order of the steps.
class OverlappingSteps {
 public:
  /// `simulation` is null for real time.
  OverlappingSteps(StepRunner& runner, Sequence& sequence, simulation::Simulation* simulation)
      : runner_(runner), sequence_(sequence), simulation_(simulation) {}

  /// Returns whether all steps were executed: not when the case took too much simulation time. Throws when no further case can run.
  bool run(const std::vector<suite::TestStep>& steps);

 private:
  /// A step that has begun.
  struct Begun {
    explicit Begun(const suite::TestStep& begunStep) : step(begunStep), result(std::make_unique<suite::CaseResult>(begunStep)) {}

    const suite::TestStep& step;
    std::unique_ptr<suite::CaseResult> result;
    std::atomic<bool> ended{false};
    /// Only of a step that overlaps.
    std::thread thread;
    Stopwatch stopwatch;
    std::exception_ptr fatal;
  };

  void begin(const suite::TestStep& step);
  void start(Begun& begun);
  void executeOnThread(Begun& begun);
  void awaitEndOf(Begun& begun);
  void pass(Begun& begun, const std::function<void()>& passing);
  void stop(Begun& begun, const std::string& reason);
  void stopAll(const std::string& reason);
  void takeCalls();
  void save();

  StepRunner& runner_;
  Sequence& sequence_;
  simulation::Simulation* simulation_;
  std::vector<std::unique_ptr<Begun>> begun_;
  std::vector<Begun*> overlapping_;
  std::size_t written_ = 0;
};

}  // namespace sitaf::runtime
