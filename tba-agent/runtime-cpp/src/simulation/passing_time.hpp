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

/// Lets simulation time pass in pieces that end where a component has something to do: at each of its periods, and when a wait of one of
/// its threads is over. Time is counted in steps since the case was prepared, and moves in the driver's thread only.
class PassingTime {
 public:
  using Duration = std::chrono::nanoseconds;

  /// A clock at 0; the simulator moves the world by a number of steps.
  PassingTime(Duration timestep, std::function<void(std::uint64_t)> simulator)
      : timestep_(timestep.count()), simulator_(std::move(simulator)) {}

  /// No case takes more simulation time than this.
  void limit(Duration mostOfCase) { most_ = mostOfCase; }

  /// A new case begins, whose driver is the calling thread, with time that has passed already; what waited for the last one goes on.
  void restart(Duration settled);

  /// A tick falls on the first step at or after each whole period from now on; ends with the case.
  void every(Duration period, std::function<void()> tick);

  /// Time passes only while this thread waits for it, until it leaves or the next case begins: what it does then happens at the same
  /// simulation time in every run. The thread must do nothing before.
  void follow(std::thread::id thread);

  /// The calling thread is at its end, and is not followed any longer.
  void leave();

  /// Lets pass what the thread that is followed still waits for; nothing where none is.
  void passUntilItLeaves();

  /// Ends the waits of the thread that is followed, each by a SimulationError.
  void giveUp();

  /// Waits are over.
  void end();

  /// Moves time in the driver's thread; in any other, waits for the driver to have moved it.
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
  /// The steps at which waiting threads go on.
  std::map<std::thread::id, std::uint64_t> waiting_;
  std::uint64_t step_ = 0;
  std::optional<Periods> periods_;
  /// No thread where none is followed, or given up.
  std::thread::id followed_;
  std::thread::id givenUp_;
  std::optional<Duration> most_;
  Duration settled_{0};
  bool ended_ = false;
};

}  // namespace sitaf::simulation
