#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <thread>

namespace sitaf::simulation {

/// Advances simulation time in pieces that end when the component has something to do: at each of its periods, and when a wait of one of
/// its threads ends. Time is counted in steps since the case was prepared; only the driver's thread advances it.
class PassingTime {
 public:
  using Duration = std::chrono::nanoseconds;

  /// Creates a clock at 0; `simulator` advances the world by a number of steps.
  PassingTime(Duration timestep, std::function<void(std::uint64_t)> simulator)
      : timestep_(timestep.count()), simulator_(std::move(simulator)) {}

  /// Limits the simulation time of each case.
  void limit(Duration mostOfCase) { most_ = mostOfCase; }

  /// Starts a new case with the calling thread as its driver and with time that has already passed; waits of the previous case end.
  void restart(Duration settled);

  /// Calls `tick` at the first step at or after each period from now, until the case ends.
  void every(Duration period, std::function<void()> tick);

  /// Lets time pass only while a thread waits for it, until the thread leaves or the next case starts. Everything that the thread does then
  /// happens at the same simulation time in every run. Call this before the thread starts its work.
  void follow(std::thread::id thread);

  /// Stops following the calling thread, which calls this at its end.
  void leave();

  /// Lets time pass until the followed thread leaves; does nothing when no thread is followed.
  void passUntilThreadLeaves();

  /// Stops following the thread: its current and later waits throw a SimulationError.
  void giveUp();

  /// Ends all waits.
  void end();

  /// Advances time in the driver's thread; other threads wait until the driver has advanced it.
  void pass(Duration time);

 private:
  struct Periods {
    std::int64_t nanos;
    std::function<void()> tick;
    std::uint64_t begin;
    std::uint64_t count = 1;
    bool atWork = false;
  };

  std::uint64_t stepsIn(Duration time) const;
  std::uint64_t at(const Periods& periods) const;
  std::uint64_t nextTick();
  void move(std::uint64_t steps);
  void await(std::uint64_t steps);
  void tickIfDue();
  void awaitFollowed(std::unique_lock<std::mutex>& lock);
  std::uint64_t awaited();

  const std::int64_t timestep_;
  const std::function<void(std::uint64_t)> simulator_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::thread::id driver_ = std::this_thread::get_id();
  /// The step at which each waiting thread continues.
  std::map<std::thread::id, std::uint64_t> waiting_;
  std::uint64_t step_ = 0;
  std::optional<Periods> periods_;
  /// Default-constructed when no thread is followed or given up.
  std::thread::id followed_;
  std::thread::id givenUp_;
  std::optional<Duration> most_;
  Duration settled_{0};
  bool ended_ = false;
};

}  // namespace sitaf::simulation
