#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "sitaf/hardware.hpp"
#include "sitaf/runtime/cannot_run.hpp"
#include "sitaf/runtime/stopwatch.hpp"
#include "sitaf/simulation/simulation.hpp"
#include "sitaf/suite/case_result.hpp"
#include "sitaf/suite/test_case.hpp"
#include "sitaf/suite/upcoming.hpp"

// Defined only in programs that are built for coverage.
extern "C" void __gcov_dump() __attribute__((weak));
extern "C" void __gcov_reset() __attribute__((weak));

namespace sitaf::runtime {
namespace detail {

/// Saves the coverage since the last call.
inline void flushCoverage() {
  __gcov_dump();
  __gcov_reset();
}

}  // namespace detail

class Driver;
class Sequence;

/// Runs a suite in this process: reads the cases, passes each to the test driver, and writes a record of every case, even when
/// the component fails.
class TestRun {
 public:
  /// Creates the test driver of a run.
  using Factory = std::function<std::unique_ptr<Driver>(TestRun&)>;

  TestRun(const TestRun&) = delete;
  TestRun& operator=(const TestRun&) = delete;

  /// The simulator's session; throws CannotRun when the test was started without one.
  simulation::Simulation& simulation();

  /// The simulator's session; null when there is none.
  simulation::Simulation* simulationIfAny();

  /// The hardware for the component; null when there is no simulation.
  Hardware* hardware();

  /// Measures the calls of this run.
  Stopwatch& stopwatch();

  /// The following cases.
  suite::Upcoming& upcoming();

  /// Registers a function that completes each result before it is saved.
  void beforeSaving(std::function<void(suite::CaseResult&)> addition);

  /// Records the value of an output data port, which `read` returns as a literal, until the end of the case.
  void watch(std::string signal, std::function<std::string()> read);

  /// Records the values of the output data ports now; throws what a port threw in this case.
  void readPorts();

  /// Writes a result to the results file.
  void save(suite::CaseResult& result);

  /// Executes the steps of a sequence and writes their records. An exception ends a step, not the sequence. Returns whether all were
  /// executed: not when the case took too much simulation time. Throws when no further case can run.
  bool runSteps(Sequence& sequence, const std::vector<suite::TestStep>& steps);

  /// The steps of a sequence have ended; what fails from now on is not a call.
  void endSteps();

 private:
  friend int start(int, char**, const Factory&, void (*)());
  class State;
  explicit TestRun(State& state) : state_(state) {}

  State& state_;
};

/// The `main` of a test application: runs the suite that the arguments name. The exit code is 0 when every case has a result, and 3, with
/// one line on the error stream, when the suite could not be run.
int start(int argc, char** argv, const TestRun::Factory& driver, void (*coverage)());

/// As start, with a driver whose constructor takes only the run.
template <class ConcreteDriver>
int start(int argc, char** argv) {
  return start(
      argc, argv, [](TestRun& run) -> std::unique_ptr<Driver> { return std::make_unique<ConcreteDriver>(run); },
      __gcov_dump != nullptr && __gcov_reset != nullptr ? &detail::flushCoverage : nullptr);
}

}  // namespace sitaf::runtime
