#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "sitaf/hardware.hpp"
#include "sitaf/runtime/stopwatch.hpp"
#include "sitaf/simulation/simulation_error.hpp"
#include "sitaf/suite/upcoming.hpp"

namespace sitaf::simulation {

/// A session of the robot simulator: prepares the virtual environment of each case and advances its time. Failures throw SimulationError.
class Simulation {
 public:
  /// Opens a session.
  ///
  /// - target: where the simulator listens, `127.0.0.1:PORT` or `unix:/absolute/path`
  /// - worldDescription: a `*.world.yaml`; all files of its folder belong to the world. std::runtime_error when it cannot be read.
  /// - seed: seed of all random values in the simulation
  /// - stopwatch: measures the time that components spend in the hardware
  Simulation(const std::string& target, const std::string& worldDescription, std::uint64_t seed, runtime::Stopwatch& stopwatch);
  ~Simulation();
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  /// The hardware for the component under test.
  Hardware& hardware();

  /// Throws SimulationError when an earlier call found the simulator or the session lost, even if the component caught the exception.
  void requireNotLost();

  /// Names of the world's parameters that a case sets, in the same order for all cases; others get their default.
  using Names = std::vector<std::string>;

  /// Prepares a case from a reset: sets parameters, in the unit of each, and lets the world settle. The onsets of faults count from the
  /// call, which begins `callAfter` later.
  void prepare(const Names& parameters, const std::vector<double>& values, std::chrono::nanoseconds settle,
               std::chrono::nanoseconds callAfter = std::chrono::nanoseconds(0));

  /// As prepare, with the same result, but also prepares the following cases. When a component commands its hardware or waits, the session
  /// is brought to the current case, and each later case is prepared separately.
  void prepareAhead(const Names& parameters, const std::vector<double>& values, std::chrono::nanoseconds settle, suite::Upcoming& upcoming);

  /// Lets simulation time pass, rounded up to whole steps.
  void advance(std::chrono::nanoseconds time);

  /// Calls a task at the first step at or after each period of simulation time, until the next case is prepared. It runs while time passes,
  /// in advance or in the component's own waits; periods that end while the task itself waits are skipped.
  void every(std::chrono::nanoseconds period, std::function<void()> task);

  /// Lets time pass only while a thread of the component waits for it, until it leaves or the next case is prepared. Everything that the
  /// thread does then happens at the same simulation time in every run. Call this before the thread starts its work.
  void follow(std::thread::id thread);

  /// Stops following the calling thread, which calls this at its end.
  void leave();

  /// Whether the calling thread is the one that advances time.
  bool isDriver();

  /// Waits until a followed thread leaves, or has left; in the driver's thread time passes meanwhile.
  void advanceUntilLeaves(std::thread::id thread);

  /// Lets time pass, in the driver's thread, until a followed thread has reached something or has left.
  void advanceUntil(std::thread::id thread, const std::function<bool()>& reached);

  /// Waits in real time until a followed thread waits for simulation time or has left.
  void awaitTurnOf(std::thread::id thread);

  /// Stops following a thread: its current and later waits throw a SimulationError.
  void giveUp(std::thread::id thread);

  /// Limits the simulation time of each case; a call that exceeds it throws CaseTooLong.
  void limitCases(std::chrono::nanoseconds most);

  /// Starts to record motion for saveMotion, and creates the folder; each case is then prepared separately.
  void record(const std::string& folder);

  /// Saves the motion of a case as NO.glb in the folder of the recording, unless the folder is full.
  void saveMotion(int no);

  /// A case begins, which the simulator notes when it is prepared.
  void caseBegins(int no);

  /// The call under test begins now. Only the first one of a case counts.
  void callBegins();

  /// Calls `look` with the time whenever it is about to pass.
  void beforeTimePasses(std::function<void(std::chrono::nanoseconds)> look);

  /// Simulation time, also of the settling.
  std::chrono::nanoseconds now() const;

  /// Simulation time since the first call of the case.
  std::chrono::nanoseconds sinceCall() const;

  /// Sets a parameter of the world in the running case, in its unit.
  void set(const std::string& parameter, double value);

  /// Lets the simulator keep the signals of the current case for the agent, if the agent wants signals. A failure is reported by the agent,
  /// which misses the signals.
  void keepSignals(int no);

  /// The value of an observation at the current step, in the unit that the world declares.
  double observation(std::string_view name) const;

 private:
  class Session;
  std::unique_ptr<Session> session_;
};

}  // namespace sitaf::simulation
