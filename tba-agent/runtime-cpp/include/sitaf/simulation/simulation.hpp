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

/// One session of the robot simulator: sets the virtual environment of a case and moves its time. Every failure is a SimulationError.
class Simulation {
 public:
  /// Opens a session.
  ///
  /// - target: where the simulator listens, `127.0.0.1:PORT` or `unix:/absolute/path`
  /// - worldDescription: a `*.world.yaml`; the world's files are all files of its folder. std::runtime_error when it cannot be read.
  /// - seed: of everything random in the simulation
  /// - stopwatch: counts what components spend in the hardware
  Simulation(const std::string& target, const std::string& worldDescription, std::uint64_t seed, runtime::Stopwatch& stopwatch);
  ~Simulation();
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  /// What a component under test gets.
  Hardware& hardware();

  /// SimulationError when a call found the simulator or the session lost, even if the component caught the exception.
  void requireThere();

  /// What a case sets: parameters of the world, in one order for all cases; those not named take their default.
  using Names = std::vector<std::string>;

  /// Prepares a case from a clean reset: sets parameters, in the unit of each, and lets time settle.
  void prepare(const Names& parameters, const std::vector<double>& values, std::chrono::nanoseconds settle);

  /// As prepare, with the same result, but prepares the cases that follow at the same time. A component that commands its hardware or waits
  /// finds a live session, as from prepare; from then on each case is prepared alone.
  void prepareAhead(const Names& parameters, const std::vector<double>& values, std::chrono::nanoseconds settle, suite::Upcoming& upcoming);

  /// Lets simulation time pass, rounded up to whole steps.
  void advance(std::chrono::nanoseconds time);

  /// From now on a task is due once a period of simulation time, on the first step at or after it, until the next case is prepared. It is
  /// called while time passes, by advance or by the component's own waiting; periods that pass while it waits itself are skipped.
  void every(std::chrono::nanoseconds period, std::function<void()> task);

  /// Lets time pass only while a thread of the component waits for it, until it leaves or the next case is prepared: what the thread does
  /// then happens at the same simulation time in every run. It must do nothing before.
  void follow(std::thread::id thread);

  /// The calling thread is at its end, and is not followed any longer.
  void leave();

  /// Lets as much time pass as the thread that is followed still waits for.
  void advanceUntilItLeaves();

  /// Ends the waits of the thread that is followed, each by a SimulationError.
  void giveUp();

  /// No case takes more simulation time than this; what lets more pass gets a CaseTooLong.
  void limitCases(std::chrono::nanoseconds most);

  /// Records from now on what moves, for saveMotion; each case is then prepared alone. The folder is made.
  void record(const std::string& folder);

  /// Puts what has moved in a case into the folder of the recording, as NO.glb; a full folder takes no more.
  void saveMotion(int no);

  /// What the world shows at the current step, in the unit that the world declares.
  double observation(std::string_view name) const;

 private:
  class Session;
  std::unique_ptr<Session> session_;
};

}  // namespace sitaf::simulation
