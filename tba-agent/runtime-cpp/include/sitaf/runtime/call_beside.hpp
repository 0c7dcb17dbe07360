#pragma once

#include <future>
#include <thread>
#include <type_traits>
#include <utility>

#include "sitaf/runtime/stopwatch.hpp"
#include "sitaf/simulation/simulation.hpp"

namespace sitaf::runtime {

/// A nonblocking call: runs on its own thread, so that time passes during the call.
template <class Returned>
class CallBeside {
 public:
  /// Begins a call. Time of the simulation, where there is one, passes only while the call waits for it.
  template <class Call>
  CallBeside(Stopwatch& stopwatch, simulation::Simulation* simulation, Call call) : simulation_(simulation) {
    std::promise<void> begin;
    std::packaged_task<Returned()> task([&stopwatch, call = std::move(call)]() -> Returned {
      stopwatch.start();
      // When it throws, the watch goes on: that is how the run knows who threw it.
      if constexpr (std::is_void_v<Returned>) {
        call();
        stopwatch.stop();
      } else {
        auto returned = call();
        stopwatch.stop();
        return returned;
      }
    });
    outcome_ = task.get_future();
    thread_ = std::thread([simulation, task = std::move(task), begun = begin.get_future()]() mutable {
      begun.wait();
      task();
      if (simulation != nullptr) {
        simulation->leave();
      }
    });
    if (simulation != nullptr) {
      simulation->follow(thread_.get_id());
    }
    begin.set_value();
  }
  CallBeside(const CallBeside&) = delete;
  CallBeside& operator=(const CallBeside&) = delete;

  /// Waits for the end of a call whose outcome was not asked for, so that it does nothing to the next case; wherever it waits for
  /// simulation time, it gets an exception.
  ~CallBeside() {
    if (thread_.joinable()) {
      if (simulation_ != nullptr) {
        simulation_->giveUp();
      }
      thread_.join();
    }
  }

  /// What the call returns, or what it throws; until then the simulation time that it waits for passes.
  Returned outcome() {
    if (simulation_ != nullptr) {
      simulation_->advanceUntilItLeaves();
    }
    thread_.join();
    return outcome_.get();
  }

 private:
  simulation::Simulation* simulation_;
  std::future<Returned> outcome_;
  std::thread thread_;
};

}  // namespace sitaf::runtime
