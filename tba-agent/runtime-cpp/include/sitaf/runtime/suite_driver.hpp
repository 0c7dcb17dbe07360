#pragma once

#include <atomic>
#include <future>
#include <memory>
#include <thread>
#include <type_traits>
#include <utility>

#include "sitaf/runtime/component.hpp"
#include "sitaf/runtime/test_run.hpp"

namespace sitaf::runtime {

/// When a component under test is made and destroyed.
enum class LifeCycle {
  /// Anew for each case.
  perCase,
  /// Once for all cases of a process.
  suite
};

/// A call on a thread of its own.
template <class Returned>
class AsideCall {
 public:
  AsideCall(std::future<Returned> outcome, std::thread thread) : outcome_(std::move(outcome)), thread_(std::move(thread)) {}
  AsideCall(AsideCall&&) = default;
  ~AsideCall() {
    if (thread_.joinable()) {
      thread_.join();
    }
  }

  std::thread::id thread() const { return thread_.get_id(); }

  /// Waits for the end of the call; what it threw comes out here.
  Returned get() {
    thread_.join();
    return outcome_.get();
  }

 private:
  std::future<Returned> outcome_;
  std::thread thread_;
};

/// Tells at the end of its life that something has ended.
class Ending {
 public:
  explicit Ending(std::atomic<bool>& ended) : ended_(ended) {}
  ~Ending() { ended_ = true; }
  Ending(const Ending&) = delete;
  Ending& operator=(const Ending&) = delete;

 private:
  std::atomic<bool>& ended_;
};

/// What a run knows of a test driver.
class Driver {
 public:
  virtual ~Driver() = default;
  Driver(const Driver&) = delete;
  Driver& operator=(const Driver&) = delete;

  /// Runs a case and says whether it got as far as saving its result.
  bool runAndSave(const suite::TestCase& testCase, suite::CaseResult& result);

  /// Whether the result of the current case is in the file.
  bool isSaved() const { return saved_; }

  /// Ends the component's life where it lives for one case.
  virtual void endCase() = 0;

  /// Ends the component's life.
  virtual void close() = 0;

 protected:
  explicit Driver(TestRun& run) : run_(run) {}

  /// Runs one case and saves its result, in the five steps of Fig. 10. What the component throws makes the case an ERROR.
  virtual void runCase(const suite::TestCase& testCase, suite::CaseResult& result) = 0;

  /// Measures the call under test.
  Stopwatch& stopwatch() { return run_.stopwatch(); }

  /// Hands the result of the case, with the time of its call, over to the results file.
  void save(suite::CaseResult& result);

  TestRun& run() { return run_; }

  /// Makes a nonblocking call on a thread of its own, and times it there. Simulation time passes meanwhile only while the call waits for
  /// it, so that what it does happens at the same time in every run.
  template <class Call>
  auto callAside(Call call) {
    auto ended = std::make_shared<std::atomic<bool>>(false);
    std::packaged_task<decltype(call())()> task([this, call, ended] {
      const Ending ending(*ended);
      stopwatch().start();
      if constexpr (std::is_void_v<decltype(call())>) {
        call();
        stopwatch().stop();
      } else {
        auto returned = call();
        stopwatch().stop();
        return returned;
      }
    });
    AsideCall<decltype(call())> aside(task.get_future(), std::thread(std::move(task)));
    if (run_.hardware() != nullptr) {
      run_.simulation().follow(aside.thread(), ended);
    }
    return aside;
  }

 private:
  TestRun& run_;
  bool saved_ = false;
};

/// What a generated test driver is built on: the life of the component, and where results go.
template <class Component>
class SuiteDriver : public Driver {
 public:
  void endCase() override {
    if (lifeCycle_ == LifeCycle::perCase) {
      close();
    }
  }

  void close() override {
    const std::unique_ptr<Component> last = std::move(component_);
    if (last != nullptr) {
      endLife(*last);
    }
  }

 protected:
  SuiteDriver(TestRun& run, LifeCycle lifeCycle) : Driver(run), lifeCycle_(lifeCycle) {}

  /// Makes the component and sets it up.
  virtual std::unique_ptr<Component> createComponent() = 0;

  /// Runs before each call, when the world and the stubs are set.
  virtual void beforeCase(Component& /*component*/, const suite::TestCase& /*testCase*/) {}

  /// Runs after each call, before the result is judged.
  virtual void afterCase(Component& /*component*/, const suite::TestCase& /*testCase*/) {}

  /// The component of this case: made now, or that of the case before where it lives as long as the suite.
  Component& component() {
    if (component_ == nullptr) {
      component_ = createComponent();
    }
    return *component_;
  }

 private:
  LifeCycle lifeCycle_;
  std::unique_ptr<Component> component_;
};

}  // namespace sitaf::runtime
