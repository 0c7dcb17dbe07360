#include "runtime/overlapping_steps.hpp"

#include <future>

#include "runtime/thrown.hpp"
#include "sitaf/simulation/simulation_error.hpp"

namespace sitaf::runtime {
namespace {

/// Ends the sequence, not the run.
struct TooLong {
  std::string message;
};

}  // namespace

bool OverlappingSteps::run(const std::vector<suite::TestStep>& steps) {
  bool complete = true;
  try {
    for (const suite::TestStep& step : steps) {
      begin(step);
    }
    for (Begun* begun : overlapping_) {
      awaitEndOf(*begun);
    }
  } catch (const TooLong& tooLong) {
    complete = false;
    stopAll(tooLong.message);
  } catch (...) {
    stopAll("the case has ended");
    throw;
  }
  takeCalls();
  save();
  return complete;
}

void OverlappingSteps::begin(const suite::TestStep& step) {
  const bool overlaps = sequence_.overlaps(step);
  if (overlaps && overlapping_.size() >= sequence_.atOnce()) {
    awaitEndOf(*overlapping_[overlapping_.size() - sequence_.atOnce()]);
  }
  takeCalls();
  save();
  begun_.push_back(std::make_unique<Begun>(step));
  Begun& begun = *begun_.back();
  runner_.begins(*begun.result);
  if (overlaps) {
    overlapping_.push_back(&begun);
    start(begun);
    return;
  }
  const std::string tooLong = runner_.execute(sequence_, step, *begun.result);
  begun.ended = true;
  if (!tooLong.empty()) {
    throw TooLong{tooLong};
  }
}

void OverlappingSteps::start(Begun& begun) {
  std::promise<void> begin;
  begun.thread = std::thread([this, &begun, may = begin.get_future()]() mutable {
    may.wait();
    executeOnThread(begun);
  });
  if (simulation_ == nullptr) {
    begin.set_value();
    return;
  }
  const std::thread::id id = begun.thread.get_id();
  simulation_->follow(id);
  begin.set_value();
  // What settles before the call passes before the next step begins.
  pass(begun, [&] { simulation_->advanceUntil(id, [&] { return begun.stopwatch.wasStarted(); }); });
}

void OverlappingSteps::executeOnThread(Begun& begun) {
  const Stopwatch::Separate own(begun.stopwatch);
  try {
    runner_.execute(sequence_, begun.step, *begun.result);
  } catch (...) {
    begun.fatal = std::current_exception();
  }
  begun.ended = true;
  if (simulation_ != nullptr) {
    simulation_->leave();
  }
}

void OverlappingSteps::awaitEndOf(Begun& begun) {
  if (!begun.thread.joinable()) {
    return;
  }
  if (simulation_ != nullptr) {
    const std::thread::id id = begun.thread.get_id();
    pass(begun, [&] { simulation_->advanceUntilLeaves(id); });
  }
  if (begun.thread.joinable()) {
    begun.thread.join();
  }
  if (begun.fatal) {
    std::rethrow_exception(begun.fatal);
  }
}

/// Lets time pass for a step; an exception of a periodic component meanwhile ends the step.
void OverlappingSteps::pass(Begun& begun, const std::function<void()>& passing) {
  try {
    passing();
  } catch (const simulation::CaseTooLong& tooLong) {
    throw TooLong{tooLong.what()};
  } catch (const simulation::SimulationError& refused) {
    if (refused.isLost()) {
      throw;
    }
    stop(begun, refused.what());
  } catch (...) {
    stop(begun, describe(std::current_exception()));
  }
}

/// Ends a step if it still runs, as an error: its waits throw an exception.
void OverlappingSteps::stop(Begun& begun, const std::string& reason) {
  if (!begun.thread.joinable()) {
    return;
  }
  const bool stopped = !begun.ended;
  if (stopped && simulation_ != nullptr) {
    simulation_->giveUp(begun.thread.get_id());
  }
  begun.thread.join();
  if (stopped) {
    begun.result->stopped(reason);
  }
}

/// Ends the steps that still run, one after the other.
void OverlappingSteps::stopAll(const std::string& reason) {
  for (Begun* begun : overlapping_) {
    stop(*begun, reason);
  }
}

/// The calls of stubs so far belong to the step that began last.
void OverlappingSteps::takeCalls() {
  if (!begun_.empty()) {
    runner_.takeCalls(*begun_.back()->result);
  }
}

/// Writes the records of steps that have ended, up to the first one that has not.
void OverlappingSteps::save() {
  for (; written_ < begun_.size() && begun_[written_]->ended; ++written_) {
    runner_.saveStep(*begun_[written_]->result);
  }
}

}  // namespace sitaf::runtime
