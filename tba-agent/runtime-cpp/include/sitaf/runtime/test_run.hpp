#pragma once

#include <functional>
#include <memory>

#include "sitaf/hardware.hpp"
#include "sitaf/runtime/cannot_run.hpp"
#include "sitaf/runtime/stopwatch.hpp"
#include "sitaf/simulation/simulation.hpp"
#include "sitaf/suite/case_result.hpp"
#include "sitaf/suite/test_case.hpp"
#include "sitaf/suite/upcoming.hpp"

// What a program that is built for coverage has, and only itself can call.
extern "C" void __gcov_dump() __attribute__((weak));
extern "C" void __gcov_reset() __attribute__((weak));

namespace sitaf::runtime {
namespace detail {

/// Writes out which lines were reached since the last time.
inline void flushCoverage() {
  __gcov_dump();
  __gcov_reset();
}

}  // namespace detail

class Driver;

/// One process that runs a suite: reads the cases, hands each to the test driver, and writes a record of every case,
/// whatever the component does.
class TestRun {
 public:
  /// Makes the test driver of a run.
  using Factory = std::function<std::unique_ptr<Driver>(TestRun&)>;

  TestRun(const TestRun&) = delete;
  TestRun& operator=(const TestRun&) = delete;

  /// The simulator's session; CannotRun where the test was started without one.
  simulation::Simulation& simulation();

  /// The simulator's session; null where there is none.
  simulation::Simulation* simulationIfAny();

  /// What the component may be given; null where there is no simulation.
  Hardware* hardware();

  /// Measures the calls of this run.
  Stopwatch& stopwatch();

  /// The cases that follow.
  suite::Upcoming& upcoming();

  /// Adds to each result before it is saved.
  void beforeSaving(std::function<void(suite::CaseResult&)> addition);

  /// Hands a result over to the results file.
  void save(suite::CaseResult& result);

 private:
  friend int start(int, char**, const Factory&, void (*)());
  class State;
  explicit TestRun(State& state) : state_(state) {}

  State& state_;
};

/// What `main` of a test application does: runs the suite that the arguments name. The exit code is 0 when every case has a result, and 3,
/// with one line on the error stream, when the suite could not be run.
int start(int argc, char** argv, const TestRun::Factory& driver, void (*coverage)());

/// As start, with a driver that is made of the run alone.
template <class ConcreteDriver>
int start(int argc, char** argv) {
  return start(
      argc, argv, [](TestRun& run) -> std::unique_ptr<Driver> { return std::make_unique<ConcreteDriver>(run); },
      __gcov_dump != nullptr && __gcov_reset != nullptr ? &detail::flushCoverage : nullptr);
}

}  // namespace sitaf::runtime
