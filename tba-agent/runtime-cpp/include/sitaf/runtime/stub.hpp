#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sitaf/runtime/test_run.hpp"
#include "sitaf/suite/answer.hpp"
#include "sitaf/suite/literals.hpp"
#include "sitaf/suite/stub_call.hpp"
#include "sitaf/suite/test_case.hpp"

namespace sitaf::runtime {

using suite::Answer;
using suite::answer;
using suite::Nothing;

/// State that all stubs of a test share: how they throw and wait, and the recorded calls.
class Stubbing {
 public:
  /// Throws the declared error with a name.
  using Raise = void (*)(const std::string& name);

  /// Adds the recorded calls to each result of the run.
  Stubbing(TestRun& run, Raise raise);
  Stubbing(const Stubbing&) = delete;
  Stubbing& operator=(const Stubbing&) = delete;

  /// Starts a case: clears the recorded calls, and sets the count of each of these methods to 0.
  void begin(const std::vector<std::string>& methods);

  /// How often a method was called in the case so far.
  std::size_t calls(const std::string& method);

  Stopwatch& stopwatch() { return run_.stopwatch(); }

 private:
  friend class StubbedCall;

  std::size_t add(suite::StubCall call);
  void act(double delay, const std::string& error);

  TestRun& run_;
  Raise raise_;
  std::mutex mutex_;
  suite::StubCalls calls_;
  /// Number of calls of each method in the case, which has a record for each step if it is a sequence.
  std::map<std::string, std::size_t> numbers_;
};

/// A call of the component to a required interface; its lifetime counts as time in stubs.
class StubbedCall {
 public:
  StubbedCall(Stubbing& stubbing, std::string_view method, std::vector<std::pair<std::string, suite::Value>> arguments);

  /// Number of this call of the method in the case, from 1.
  std::size_t number() const { return number_; }

  /// Waits for the delay of the answer and throws its error, if it has one.
  void act(double delay, const std::string& error) const { stubbing_.act(delay, error); }

 private:
  Stopwatch::ExcludedTime excluded_;
  Stubbing& stubbing_;
  std::size_t number_;
};

/// The answers of a method in a case; each applies from its call until the next call that has an answer.
template <class T>
class Answers {
 public:
  /// Resets the answers to the default value of the type.
  void reset() { replace({}, 0); }

  void set(std::size_t fromCall, Answer<T> answer) {
    const std::lock_guard<std::mutex> lock(mutex_);
    byCall_[fromCall] = std::move(answer);
  }

  /// Replaces the answers in the running case, while other threads may call the method. Calls of the new answers are
  /// counted after the `before` calls that were made so far.
  void replace(std::map<std::size_t, Answer<T>> byCall, std::size_t before) {
    const std::lock_guard<std::mutex> lock(mutex_);
    byCall_ = std::move(byCall);
    before_ = before;
  }

  /// Handles a call: waits, then throws or returns the answer.
  T give(const StubbedCall& call) const {
    const Answer<T> answer = of(call.number());
    call.act(answer.delay, answer.error);
    return answer.value;
  }

 private:
  Answer<T> of(std::size_t number) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    // A call that was recorded before the answers were replaced gets the first of the new ones.
    auto next = byCall_.upper_bound(number > before_ ? number - before_ : 1);
    return next == byCall_.begin() ? Answer<T>{} : (--next)->second;
  }

  mutable std::mutex mutex_;
  std::map<std::size_t, Answer<T>> byCall_;
  std::size_t before_ = 0;
};

/// An argument in the record of a call.
template <class T>
std::pair<std::string, suite::Value> argument(const char* name, const T& value) {
  return {name, suite::valueOf(value)};
}

}  // namespace sitaf::runtime
