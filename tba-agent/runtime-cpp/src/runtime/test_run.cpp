#include "sitaf/runtime/test_run.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <optional>
#include <stdexcept>

#include "runtime/case_streams.hpp"
#include "runtime/command_line.hpp"
#include "runtime/crash_reports.hpp"
#include "runtime/debugger.hpp"
#include "runtime/overlapping_steps.hpp"
#include "runtime/thrown.hpp"
#include "sitaf/runtime/sequence_driver.hpp"
#include "sitaf/runtime/suite_driver.hpp"
#include "sitaf/runtime/watched_ports.hpp"
#include "suite/results_file.hpp"
#include "suite/suite_reader.hpp"

namespace sitaf {
namespace {

/// Global because a process runs a single suite.
Hardware* currentHardware = nullptr;

}  // namespace

Hardware& Hardware::current() {
  if (currentHardware == nullptr) {
    throw std::logic_error("there is no virtual hardware: no test with a simulated world is running (does the activity name a world?)");
  }
  return *currentHardware;
}

namespace runtime {
namespace {

constexpr int exitDone = 0;
constexpr int exitCannotRun = 3;

int cannotRun(const std::string& reason) {
  std::string line;
  for (const char c : reason) {
    line += c == '\n' ? ';' : c == '\r' ? ' ' : c;
  }
  std::fflush(stdout);
  std::fprintf(stderr, "sitaf: %s\n", line.c_str());
  return exitCannotRun;
}

/// Runs a clean-up step after a case. A failure is printed and does not change the result.
template <class Closing>
void closing(const std::string& what, Closing close) {
  try {
    close();
  } catch (...) {
    std::fprintf(stderr, "sitaf: %s: %s\n", what.c_str(), describe(std::current_exception()).c_str());
  }
}

}  // namespace

class TestRun::State : private StepRunner {
 public:
  explicit State(const CommandLine& command)
      : from_(command.from), repetition_(command.repetition), suite(command.suite), results(command.results, command.from > 0) {
    if (command.bridge) {
      simulation.emplace(*command.bridge, *command.world, command.seed, stopwatch);
      currentHardware = &simulation->hardware();
      stopwatch.beforeCall([this] { simulation->callBegins(); });
      simulation->beforeTimePasses([this](std::chrono::nanoseconds now) { ports.take(now); });
      if (command.caseTime) {
        simulation->limitCases(*command.caseTime);
      }
      if (!command.recording.empty()) {
        simulation->record(command.recording);
      }
    }
  }
  ~State() override { currentHardware = nullptr; }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  void save(suite::CaseResult& result) {
    if (repeating_) {
      ports.clear();
      requireSimulator();
      return;
    }
    if (simulation && (stopwatch.wasStarted() || inSequence_)) {
      simulation->keepSignals(suite.current().no());
    }
    if (simulation) {
      ports.writeTo(result, simulation->now() - simulation->sinceCall());
    }
    ports.clear();
    requireSimulator();
    if (addition) {
      addition(result);
    }
    if (!repetition_) {
      results.save(result);
    }
  }

  bool runSteps(Sequence& sequence, const std::vector<suite::TestStep>& steps) {
    if (std::any_of(steps.begin(), steps.end(), [&](const suite::TestStep& step) { return sequence.overlaps(step); })) {
      return OverlappingSteps(*this, sequence, simulation ? &*simulation : nullptr).run(steps);
    }
    return std::all_of(steps.begin(), steps.end(), [&](const suite::TestStep& step) {
      suite::CaseResult result(step);
      begins(result);
      const bool goesOn = execute(sequence, step, result).empty();
      takeCalls(result);
      results.save(result);
      return goesOn;
    });
  }

  void begins(suite::CaseResult& result) override {
    if (simulation) {
      if (!inSequence_) {
        simulation->callBegins();
      }
      result.beganAt(simulation->sinceCall());
    }
    inSequence_ = true;
  }

  std::string execute(Sequence& sequence, const suite::TestStep& step, suite::CaseResult& result) override {
    Stopwatch& watch = stopwatch.ofThisThread();
    watch.reset();
    std::string tooLong;
    try {
      sequence.runStep(step, result);
      if (watch.wasStarted()) {
        setTime(result, watch);
      }
    } catch (const simulation::CaseTooLong& e) {
      tooLong = e.what();
      end(result, std::current_exception());
    } catch (...) {
      end(result, std::current_exception());
    }
    requireSimulator();
    return tooLong;
  }

  void takeCalls(suite::CaseResult& result) override {
    if (addition) {
      addition(result);
    }
  }

  void saveStep(suite::CaseResult& result) override { results.save(result); }

  /// Throws when the simulator was lost, because later measurements are invalid.
  void requireSimulator() {
    if (simulation) {
      simulation->requireNotLost();
    }
  }

  void runAll(Driver& driver) {
    bool hasCase = suite.next();
    while (hasCase && from_ > 0 && suite.current().no() != from_) {
      hasCase = suite.next();
    }
    if (from_ > 0 && !hasCase) {
      throw CannotRun("--from " + std::to_string(from_) + ": the suite has no case of that number");
    }
    results.ready();
    for (; hasCase; hasCase = suite.next()) {
      runOne(driver, suite.current());
      saveCoverage(false);
    }
    beginCase(0);
    closing("closing the component", [&] { driver.close(); });
  }

 private:
  void runOne(Driver& driver, const suite::TestCase& testCase) {
    suite::CaseResult result(testCase);
    beginCase(testCase.no());
    if (simulation) {
      simulation->caseBegins(testCase.no());
    }
    if (!repetition_) {
      call(driver, testCase, result);
      return;
    }
    const auto began = std::chrono::steady_clock::now();
    call(driver, testCase, result);
    if (result.isRepeatable()) {
      repeating_ = true;
      repeat(driver, testCase, result, began);
      repeating_ = false;
    }
    results.save(result);
  }

  /// Repeats the call of a case, each time in the same world and with a new component.
  void repeat(Driver& driver, const suite::TestCase& testCase, suite::CaseResult& first, std::chrono::steady_clock::time_point began) {
    first.beginRepeated();
    for (int i = 0; i < repetition_->warmUp + repetition_->repeat; ++i) {
      if (std::chrono::steady_clock::now() - began > repetition_->within) {
        break;
      }
      suite::CaseResult again(testCase);
      call(driver, testCase, again);
      first.addRepeated(again, i + 2, i >= repetition_->warmUp);
    }
  }

  void call(Driver& driver, const suite::TestCase& testCase, suite::CaseResult& result) {
    stopwatch.reset();
    inSequence_ = false;
    try {
      if (!driver.runAndSave(testCase, result)) {
        throw CannotRun("the test driver ended case " + std::to_string(testCase.no()) + " without save(result)");
      }
    } catch (...) {
      const std::exception_ptr thrown = std::current_exception();
      if (driver.isSaved()) {
        std::fprintf(stderr, "sitaf: after case %d: %s\n", testCase.no(), describe(thrown).c_str());
      } else {
        end(result, thrown);
        save(result);
      }
    }
    if (simulation && !repeating_) {
      closing("recording case " + std::to_string(testCase.no()), [&] { simulation->saveMotion(testCase.no()); });
    }
    closing("closing the component after case " + std::to_string(testCase.no()), [&] { driver.endCase(); });
  }

  static void setTime(suite::CaseResult& result, const Stopwatch& watch) {
    result.setTime(watch.componentMicros(), watch.hardwareMicros(), watch.stubMicros());
  }

  /// Completes the record of a case that did not save its result; rethrows when no further case can run.
  void end(suite::CaseResult& result, const std::exception_ptr& thrown) {
    requireSimulator();
    Stopwatch& watch = stopwatch.ofThisThread();
    const std::string text = describe(thrown);
    try {
      std::rethrow_exception(thrown);
    } catch (const simulation::CaseTooLong& tooLong) {
      result.endWith(suite::Outcome::error, tooLong.what());
      return;
    } catch (...) {
      if (watch.isRunning()) {
        watch.stop();
        setTime(result, watch);
        result.threw(simpleTypeOf(thrown), text);
        return;
      }
    }
    try {
      std::rethrow_exception(thrown);
    } catch (const CannotRun&) {
      throw;
    } catch (const simulation::SimulationError& refused) {
      if (refused.isLost()) {
        throw;
      }
      result.endWith(watch.wasStarted() ? suite::Outcome::error : suite::Outcome::notCalled, refused.what());
    } catch (const suite::CaseDataError& unreadable) {
      result.endWith(suite::Outcome::notCalled, unreadable.what());
    } catch (...) {
      result.endWith(suite::Outcome::error, text);
    }
  }

  const int from_;
  const std::optional<Repetition> repetition_;
  /// Whether the current call is repeated, so that only its time and its outputs count.
  bool repeating_ = false;
  /// Whether a step of the current case has begun.
  bool inSequence_ = false;

 public:
  Stopwatch stopwatch;
  suite::SuiteReader suite;
  suite::ResultsFile results;
  std::optional<simulation::Simulation> simulation;
  std::function<void(suite::CaseResult&)> addition;
  WatchedPorts ports;
};

simulation::Simulation& TestRun::simulation() {
  if (!state_.simulation) {
    throw CannotRun("this test needs a simulation: start it with --bridge TARGET --world FILE.world.yaml");
  }
  return *state_.simulation;
}

simulation::Simulation* TestRun::simulationIfAny() { return state_.simulation ? &*state_.simulation : nullptr; }

Hardware* TestRun::hardware() { return state_.simulation ? &state_.simulation->hardware() : nullptr; }

Stopwatch& TestRun::stopwatch() { return state_.stopwatch; }

suite::Upcoming& TestRun::upcoming() { return state_.suite; }

void TestRun::beforeSaving(std::function<void(suite::CaseResult&)> addition) { state_.addition = std::move(addition); }

void TestRun::watch(std::string signal, std::function<std::string()> read) {
  if (state_.simulation) {
    state_.ports.watch(std::move(signal), std::move(read), state_.simulation->now());
  }
}

void TestRun::readPorts() {
  if (state_.simulation) {
    state_.ports.take(state_.simulation->now());
    state_.ports.requireRead();
  }
}

void TestRun::save(suite::CaseResult& result) { state_.save(result); }

bool TestRun::runSteps(Sequence& sequence, const std::vector<suite::TestStep>& steps) { return state_.runSteps(sequence, steps); }

void TestRun::endSteps() { state_.stopwatch.reset(); }

void Driver::saveSequence(suite::CaseResult& result) {
  run_.readPorts();
  run_.save(result);
  saved_ = true;
}

bool Driver::runAndSave(const suite::TestCase& testCase, suite::CaseResult& result) {
  saved_ = false;
  runCase(testCase, result);
  return saved_;
}

void Driver::save(suite::CaseResult& result) {
  run_.readPorts();
  const Stopwatch& watch = run_.stopwatch();
  result.setTime(watch.componentMicros(), watch.hardwareMicros(), watch.stubMicros());
  run_.save(result);
  saved_ = true;
}

int start(int argc, char** argv, const TestRun::Factory& factory, void (*coverage)()) {
  waitForDebugger();
  markCases();
  installCrashHandlers(coverage);
  try {
    TestRun::State state(CommandLine::parse(argc, argv));
    TestRun run(state);
    const std::unique_ptr<Driver> driver = factory(run);
    state.runAll(*driver);
    return exitDone;
  } catch (const std::exception& e) {
    return cannotRun(e.what());
  } catch (...) {
    return cannotRun(describe(std::current_exception()));
  }
}

}  // namespace runtime
}  // namespace sitaf
