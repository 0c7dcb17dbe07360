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
  followed_.clear();
  joining_.clear();
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
  followed_.push_back(thread);
}

void PassingTime::leave() {
  const std::lock_guard<std::mutex> lock(mutex_);
  givenUp_.erase(std::this_thread::get_id());
  unfollow(std::this_thread::get_id());
}

bool PassingTime::isFollowed(std::thread::id thread) const {
  return std::find(followed_.begin(), followed_.end(), thread) != followed_.end();
}

void PassingTime::unfollow(std::thread::id thread) {
  const auto found = std::find(followed_.begin(), followed_.end(), thread);
  if (found == followed_.end()) {
    return;
  }
  followed_.erase(found);
  const auto joiner = joining_.find(thread);
  if (joiner != joining_.end()) {
    waiting_.erase(joiner->second);
    joining_.erase(joiner);
  }
  changed_.notify_all();
}

void PassingTime::passUntilLeaves(std::thread::id thread) {
  if (isDriver()) {
    passUntil(thread, [] { return false; });
  } else {
    join(thread);
  }
}

void PassingTime::passUntil(std::thread::id thread, const std::function<bool()>& reached) {
  for (std::uint64_t steps = untilNext(thread); steps > 0 && !reached(); steps = untilNext(thread)) {
    move(steps);
  }
}

void PassingTime::awaitTurnOf(std::thread::id thread) {
  std::unique_lock<std::mutex> lock(mutex_);
  changed_.wait(lock, [&] { return !isFollowed(thread) || waiting_.count(thread) > 0; });
}

void PassingTime::giveUp(std::thread::id thread) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (isFollowed(thread)) {
    givenUp_.insert(thread);
    unfollow(thread);
  }
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
  if (isDriver()) {
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
      std::unique_lock<std::mutex> lock(mutex_);
      step_ = stop;
      continueDue(lock);
    }
    tickIfDue();
  }
  std::unique_lock<std::mutex> lock(mutex_);
  awaitFollowed(lock);
}

/// Ends the waits that are over; followed threads continue one after the other.
void PassingTime::continueDue(std::unique_lock<std::mutex>& lock) {
  for (auto waiter = waiting_.begin(); waiter != waiting_.end();) {
    waiter = waiter->second <= step_ && !isFollowed(waiter->first) ? waiting_.erase(waiter) : std::next(waiter);
  }
  changed_.notify_all();
  const std::vector<std::thread::id> inOrder = followed_;
  for (const std::thread::id thread : inOrder) {
    const auto waiter = waiting_.find(thread);
    if (waiter != waiting_.end() && waiter->second <= step_) {
      waiting_.erase(waiter);
      changed_.notify_all();
      awaitFollowed(lock);
    }
  }
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
  waiting_[std::this_thread::get_id()] = step_ + steps;
  waitUntilRemoved(lock);
}

/// Waits until another thread leaves.
void PassingTime::join(std::thread::id other) {
  std::unique_lock<std::mutex> lock(mutex_);
  if (isFollowed(other)) {
    joining_[other] = std::this_thread::get_id();
    waiting_[std::this_thread::get_id()] = never;
    waitUntilRemoved(lock);
  }
}

void PassingTime::waitUntilRemoved(std::unique_lock<std::mutex>& lock) {
  const std::thread::id self = std::this_thread::get_id();
  changed_.notify_all();
  changed_.wait(lock, [&] { return ended_ || givenUp_.count(self) > 0 || waiting_.count(self) == 0; });
  if (givenUp_.count(self) > 0) {
    waiting_.erase(self);
    throw SimulationError("the case has ended, and its simulation time no longer advances", false);
  }
}

/// Waits until each followed thread waits for simulation time or has left.
void PassingTime::awaitFollowed(std::unique_lock<std::mutex>& lock) {
  changed_.wait(lock, [&] {
    return std::all_of(followed_.begin(), followed_.end(), [&](std::thread::id thread) { return waiting_.count(thread) > 0; });
  });
}

/// Steps until the first followed thread continues; 0 when this one has left.
std::uint64_t PassingTime::untilNext(std::thread::id thread) {
  std::unique_lock<std::mutex> lock(mutex_);
  awaitFollowed(lock);
  if (!isFollowed(thread)) {
    return 0;
  }
  std::uint64_t next = never;
  for (const std::thread::id each : followed_) {
    next = std::min(next, waiting_.at(each));
  }
  return next - step_;
}

}  // namespace sitaf::simulation
