#include "sitaf/runtime/stub.hpp"

#include <chrono>
#include <thread>

namespace sitaf::runtime {
namespace {

/// Maximum number of recorded calls per case; a component may make any number of calls.
constexpr std::size_t maxRecordedCalls = 1000;

}  // namespace

void Stubbing::begin(const std::vector<std::string>& methods) {
  const std::lock_guard<std::mutex> lock(mutex_);
  calls_ = {};
  numbers_.clear();
  for (const std::string& method : methods) {
    calls_.counts[method] = 0;
  }
}

Stubbing::Stubbing(TestRun& run, Raise raise) : run_(run), raise_(raise) {
  run.beforeSaving([this](suite::CaseResult& result) {
    const std::lock_guard<std::mutex> lock(mutex_);
    result.setCalls(std::move(calls_));
    calls_ = {};
  });
}

std::size_t Stubbing::calls(const std::string& method) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto known = numbers_.find(method);
  return known == numbers_.end() ? 0 : known->second;
}

std::size_t Stubbing::add(suite::StubCall call) {
  const std::lock_guard<std::mutex> lock(mutex_);
  ++calls_.counts[call.method];
  const std::size_t number = ++numbers_[call.method];
  if (calls_.first.size() < maxRecordedCalls) {
    calls_.first.push_back(std::move(call));
  }
  return number;
}

void Stubbing::act(double delay, const std::string& error) {
  if (delay > 0) {
    const auto time = std::chrono::nanoseconds(static_cast<std::int64_t>(delay * 1e9));
    if (Hardware* hardware = run_.hardware()) {
      hardware->sleep(time);
    } else {
      std::this_thread::sleep_for(time);
    }
  }
  if (!error.empty()) {
    raise_(error);
  }
}

StubbedCall::StubbedCall(Stubbing& stubbing, std::string_view method, std::vector<std::pair<std::string, suite::Value>> arguments)
    : excluded_(stubbing.stopwatch(), Stopwatch::ExcludedTime::Kind::stub), stubbing_(stubbing), number_(0) {
  suite::StubCall call{std::string(method), {}};
  for (auto& [name, value] : arguments) {
    call.arguments.emplace_back(std::move(name), suite::literals::write(value));
  }
  number_ = stubbing.add(std::move(call));
}

}  // namespace sitaf::runtime
