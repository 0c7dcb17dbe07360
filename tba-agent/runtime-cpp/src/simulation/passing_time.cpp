#include "simulation/passing_time.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "sitaf/simulation/simulation_error.hpp"

namespace sitaf::simulation {
namespace {

constexpr std::uint64_t never = std::numeric_limits<std::uint64_t>::max();

}  // namespace

void PassingTime::restart(Duration settled) {
  const std::lock_guard<std::mutex> lock(mutex_);
  driver_ = std::this_thread::get_id();
  periods_.reset();
  followed_ = {};
  waiting_.clear();
  step_ = 0;
  settled_ = settled;
  changed_.notify_all();
}

void PassingTime::every(Duration period, std::function<void()> tick) {
  if (period.count() <= 0) {
    throw std::invalid_argument("the period must be above zero");
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  periods_ = Periods{period.count(), std::move(tick), step_};
}

void PassingTime::follow(std::thread::id thread) {
  const std::lock_guard<std::mutex> lock(mutex_);
  followed_ = thread;
  givenUp_ = {};
}

void PassingTime::leave() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (followed_ == std::this_thread::get_id()) {
    followed_ = {};
    changed_.notify_all();
  }
}

void PassingTime::passUntilThreadLeaves() {
  for (std::uint64_t steps = awaited(); steps > 0; steps = awaited()) {
    move(steps);
  }
}

void PassingTime::giveUp() {
  const std::lock_guard<std::mutex> lock(mutex_);
  givenUp_ = followed_;
  followed_ = {};
  changed_.notify_all();
}

void PassingTime::end() {
  const std::lock_guard<std::mutex> lock(mutex_);
  ended_ = true;
  changed_.notify_all();
}

void PassingTime::pass(Duration time) {
  const std::uint64_t steps = stepsIn(time);
  if (steps == 0) {
    return;
  }
  if (std::this_thread::get_id() == driver_) {
    move(steps);
  } else {
    await(steps);
  }
}

std::uint64_t PassingTime::stepsIn(Duration time) const {
  return time.count() <= 0 ? 0 : static_cast<std::uint64_t>((time.count() - 1) / timestep_ + 1);
}

std::uint64_t PassingTime::at(const Periods& periods) const {
  const auto due = static_cast<std::int64_t>(periods.count) * periods.nanos;
  return periods.begin + static_cast<std::uint64_t>((due - 1) / timestep_ + 1);
}

std::uint64_t PassingTime::nextTick() {
  if (!periods_ || periods_->atWork) {
    return never;
  }
  // Ticks during a sleep of the component itself are skipped.
  while (at(*periods_) <= step_) {
    ++periods_->count;
  }
  return at(*periods_);
}

void PassingTime::move(std::uint64_t steps) {
  const std::uint64_t end = step_ + steps;
  const Duration total = settled_ + Duration(static_cast<std::int64_t>(end) * timestep_);
  if (most_ && total > *most_) {
    throw CaseTooLong(*most_);
  }
  while (step_ < end) {
    std::uint64_t stop = 0;
    {
      std::unique_lock<std::mutex> lock(mutex_);
      awaitFollowed(lock);
      stop = std::min(end, nextTick());
      for (const auto& [thread, target] : waiting_) {
        stop = target > step_ ? std::min(stop, target) : stop;
      }
    }
    simulator_(stop - step_);
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      step_ = stop;
      for (auto waiter = waiting_.begin(); waiter != waiting_.end();) {
        waiter = waiter->second <= step_ ? waiting_.erase(waiter) : std::next(waiter);
      }
      changed_.notify_all();
    }
    tickIfDue();
  }
  std::unique_lock<std::mutex> lock(mutex_);
  awaitFollowed(lock);
}

void PassingTime::tickIfDue() {
  if (!periods_ || periods_->atWork || at(*periods_) != step_) {
    return;
  }
  ++periods_->count;
  periods_->atWork = true;
  try {
    periods_->tick();
  } catch (...) {
    periods_->atWork = false;
    throw;
  }
  periods_->atWork = false;
}

void PassingTime::await(std::uint64_t steps) {
  std::unique_lock<std::mutex> lock(mutex_);
  const std::thread::id self = std::this_thread::get_id();
  waiting_[self] = step_ + steps;
  changed_.notify_all();
  changed_.wait(lock, [&] { return ended_ || givenUp_ == self || waiting_.count(self) == 0; });
  if (givenUp_ == self) {
    waiting_.erase(self);
    throw SimulationError("the case has ended, and its simulation time no longer advances", false);
  }
}

/// Waits until the followed thread waits for simulation time or has left.
void PassingTime::awaitFollowed(std::unique_lock<std::mutex>& lock) {
  changed_.wait(lock, [&] { return followed_ == std::thread::id() || waiting_.count(followed_) > 0; });
}

/// Steps that the followed thread waits for; 0 when it has left.
std::uint64_t PassingTime::awaited() {
  std::unique_lock<std::mutex> lock(mutex_);
  awaitFollowed(lock);
  return followed_ == std::thread::id() ? 0 : waiting_.at(followed_) - step_;
}

}  // namespace sitaf::simulation
