#pragma once

#include <future>
#include <thread>
#include <type_traits>
#include <utility>

#include "sitaf/runtime/stopwatch.hpp"
#include "sitaf/simulation/simulation.hpp"

namespace sitaf::runtime {

/// A nonblocking call. It runs on its own thread, so that simulation time passes during the call.
template <class Returned>
class NonblockingCall {
 public:
  /// Starts a call. With a simulation, simulation time passes only while the call waits for it.
  template <class Call>
  NonblockingCall(Stopwatch& stopwatch, simulation::Simulation* simulation, Call call) : simulation_(simulation) {
    std::promise<void> begin;
    std::packaged_task<Returned()> task([&stopwatch = stopwatch.ofThisThread(), call = std::move(call)]() -> Returned {
      const Stopwatch::Separate own(stopwatch);
      stopwatch.start();
      // When the call throws, the stopwatch keeps running, so the run attributes the exception to the component.
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
    if (simulation != nullptr && !simulation->isDriver()) {
      // The caller is a followed thread, too: one of them runs at a time.
      simulation->awaitTurnOf(thread_.get_id());
    }
  }
  NonblockingCall(const NonblockingCall&) = delete;
  NonblockingCall& operator=(const NonblockingCall&) = delete;

  /// Ends a call whose outcome was not read, so that it does not affect the next case: its waits for simulation time throw an
  /// exception. Returns when the call has ended.
  ~NonblockingCall() {
    if (thread_.joinable()) {
      if (simulation_ != nullptr) {
        simulation_->giveUp(thread_.get_id());
      }
      thread_.join();
    }
  }

  /// Waits for the call and returns its value or throws its exception; meanwhile simulation time passes when the call waits for it.
  Returned outcome() {
    if (simulation_ != nullptr) {
      simulation_->advanceUntilLeaves(thread_.get_id());
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
