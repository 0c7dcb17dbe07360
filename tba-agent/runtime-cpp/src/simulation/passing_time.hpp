#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <thread>
#include <vector>

namespace sitaf::simulation {

/// Advances simulation time in pieces that end when the component has something to do: at each of its periods, and when a wait of one of
/// its threads ends. Time is counted in steps since the case was prepared; only the driver's thread advances it.
///
/// Followed threads make this deterministic: time advances only while each of them waits for it, and those that continue at the same step
/// do so one after the other, in the order in which they were followed, each until it waits again or leaves.
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

  /// Whether the calling thread is the one that advances time.
  bool isDriver() const { return std::this_thread::get_id() == driver_; }

  /// Waits until a followed thread leaves, or has left; in the driver's thread time passes meanwhile.
  void passUntilLeaves(std::thread::id thread);

  /// Lets time pass, in the driver's thread, until a followed thread has reached something or has left.
  void passUntil(std::thread::id thread, const std::function<bool()>& reached);

  /// Waits in real time until a followed thread waits for simulation time or has left.
  void awaitTurnOf(std::thread::id thread);

  /// Stops following a thread: its current and later waits throw a SimulationError.
  void giveUp(std::thread::id thread);

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
  void continueDue(std::unique_lock<std::mutex>& lock);
  void join(std::thread::id other);
  void waitUntilRemoved(std::unique_lock<std::mutex>& lock);
  bool isFollowed(std::thread::id thread) const;
  void unfollow(std::thread::id thread);
  std::uint64_t untilNext(std::thread::id thread);

  const std::int64_t timestep_;
  const std::function<void(std::uint64_t)> simulator_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::atomic<std::thread::id> driver_ = std::this_thread::get_id();
  /// The step at which each waiting thread continues.
  std::map<std::thread::id, std::uint64_t> waiting_;
  std::uint64_t step_ = 0;
  std::optional<Periods> periods_;
  /// In the order of their beginning.
  std::vector<std::thread::id> followed_;
  std::set<std::thread::id> givenUp_;
  /// The thread that waits until the key leaves.
  std::map<std::thread::id, std::thread::id> joining_;
  std::optional<Duration> most_;
  Duration settled_{0};
  bool ended_ = false;
};

}  // namespace sitaf::simulation
