#include "sitaf/runtime/stub.hpp"

#include <charconv>
#include <chrono>
#include <thread>

namespace sitaf::runtime {
namespace {

constexpr std::string_view delayMark = "!delay:";
constexpr std::string_view errorMark = "!error:";
/// Calls of a case that are kept; what a component asks for in a loop has no bound of its own.
constexpr std::size_t keptCalls = 1000;

bool startsWith(std::string_view text, std::string_view mark) { return text.substr(0, mark.size()) == mark; }

}  // namespace

std::string_view readAnswer(std::string_view literal, double& delay, std::string& error, bool& hasValue) {
  std::string_view rest = literal;
  hasValue = true;
  if (startsWith(rest, delayMark)) {
    rest.remove_prefix(delayMark.size());
    const auto [end, problem] = std::from_chars(rest.data(), rest.data() + rest.size(), delay);
    rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
    if (problem != std::errc() || !(delay >= 0) || (!rest.empty() && rest.front() != ' ')) {
      suite::literals::refuse(literal, "is not a delay such as !delay:0.5 or !delay:0.5 VALUE, in seconds");
    }
    hasValue = !rest.empty();
    rest.remove_prefix(rest.empty() ? 0 : 1);
  }
  if (startsWith(rest, errorMark)) {
    error = rest.substr(errorMark.size());
    hasValue = false;
  }
  return rest;
}

void Stubbing::begin(const std::vector<std::string>& methods) {
  const std::lock_guard<std::mutex> lock(mutex_);
  calls_ = {};
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

std::size_t Stubbing::add(suite::StubCall call) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const std::size_t number = ++calls_.counts[call.method];
  if (calls_.first.size() < keptCalls) {
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
    : aside_(stubbing.stopwatch(), Stopwatch::Aside::Kind::stub), stubbing_(stubbing), number_(0) {
  suite::StubCall call{std::string(method), {}};
  for (auto& [name, value] : arguments) {
    call.arguments.emplace_back(std::move(name), suite::literals::write(value));
  }
  number_ = stubbing.add(std::move(call));
}

}  // namespace sitaf::runtime
