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

/// What all stubs of a test share: how they throw and wait, and the record of their calls.
class Stubbing {
 public:
  /// Throws the error of a name.
  using Raise = void (*)(const std::string& name);

  /// The record of the calls goes into each result of the run.
  Stubbing(TestRun& run, Raise raise);
  Stubbing(const Stubbing&) = delete;
  Stubbing& operator=(const Stubbing&) = delete;

  /// Forgets the calls of the case before; from now on every method of these has a record.
  void begin(const std::vector<std::string>& methods);

  Stopwatch& stopwatch() { return run_.stopwatch(); }

 private:
  friend class StubbedCall;

  std::size_t add(suite::StubCall call);
  void act(double delay, const std::string& error);

  TestRun& run_;
  Raise raise_;
  std::mutex mutex_;
  suite::StubCalls calls_;
};

/// A call that the component makes of a required interface; its life counts as the stub's time.
class StubbedCall {
 public:
  StubbedCall(Stubbing& stubbing, std::string_view method, std::vector<std::pair<std::string, suite::Value>> arguments);

  /// Which call of this method in this case it is, from 1.
  std::size_t number() const { return number_; }

  /// Waits and throws, as the answer says.
  void act(double delay, const std::string& error) const { stubbing_.act(delay, error); }

 private:
  Stopwatch::Aside aside_;
  Stubbing& stubbing_;
  std::size_t number_;
};

/// What a method answers over its calls in a case: each answer holds from its call on to the next that has its own.
template <class T>
class Answers {
 public:
  /// Goes back to the zero of the type.
  void reset() { byCall_.clear(); }

  void set(std::size_t fromCall, Answer<T> answer) { byCall_[fromCall] = std::move(answer); }

  /// Waits, throws or answers a call.
  T give(const StubbedCall& call) const {
    auto next = byCall_.upper_bound(call.number());
    if (next == byCall_.begin()) {
      return T{};
    }
    const Answer<T>& answer = (--next)->second;
    call.act(answer.delay, answer.error);
    return answer.value;
  }

 private:
  std::map<std::size_t, Answer<T>> byCall_;
};

/// An argument for the record of a call.
template <class T>
std::pair<std::string, suite::Value> argument(const char* name, const T& value) {
  return {name, suite::valueOf(value)};
}

}  // namespace sitaf::runtime
