#include "runtime/command_line.hpp"

#include <algorithm>
#include <charconv>
#include <limits>
#include <map>

#include "sitaf/runtime/cannot_run.hpp"

namespace sitaf::runtime {
namespace {

[[noreturn]] void refuse(const std::string& problem) {
  throw CannotRun(problem +
                  "; usage: --suite FILE --results FILE [--bridge TARGET --world FILE.world.yaml] [--seed N] [--from NO] "
                  "[--recording FOLDER] [--case-sim SECONDS] [--repeat N [--warm-up N] [--repeat-within SECONDS]]");
}

std::uint64_t number(const std::map<std::string, std::string>& given, const std::string& option, std::uint64_t otherwise) {
  const auto found = given.find(option);
  if (found == given.end()) {
    return otherwise;
  }
  const std::string& text = found->second;
  std::uint64_t value = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (problem != std::errc() || end != text.data() + text.size()) {
    refuse(option + ": '" + text + "' is not a whole number from 0");
  }
  return value;
}

std::optional<std::chrono::nanoseconds> seconds(const std::map<std::string, std::string>& given, const std::string& option) {
  const auto found = given.find(option);
  if (found == given.end()) {
    return std::nullopt;
  }
  const std::string& text = found->second;
  double value = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (problem != std::errc() || end != text.data() + text.size() || !(value > 0) || value > 1e9) {
    refuse(option + ": '" + text + "' is not a number of seconds above 0");
  }
  return std::chrono::nanoseconds(static_cast<std::int64_t>(value * 1e9));
}

std::optional<Repetition> repetitionOf(const std::map<std::string, std::string>& given) {
  if (given.count("--repeat") == 0) {
    if (given.count("--warm-up") > 0 || given.count("--repeat-within") > 0) {
      refuse("--warm-up and --repeat-within need --repeat");
    }
    return std::nullopt;
  }
  // More repeated calls of either kind are never made.
  constexpr std::uint64_t most = 10'000;
  Repetition repetition;
  repetition.warmUp = static_cast<int>(std::min(number(given, "--warm-up", 0), most));
  repetition.repeat = static_cast<int>(std::min(number(given, "--repeat", 0), most));
  repetition.within = seconds(given, "--repeat-within").value_or(repetition.within);
  return repetition;
}

}  // namespace

CommandLine CommandLine::parse(int argc, char** argv) {
  std::map<std::string, std::string> given;
  for (int i = 1; i < argc; i += 2) {
    const std::string option = argv[i];
    const bool known = option == "--suite" || option == "--results" || option == "--bridge" || option == "--world" || option == "--seed" ||
                       option == "--from" || option == "--recording" || option == "--case-sim" || option == "--repeat" ||
                       option == "--warm-up" || option == "--repeat-within";
    if (!known || i + 1 == argc) {
      refuse("'" + option + "' is not an option with a value");
    }
    if (!given.emplace(option, argv[i + 1]).second) {
      refuse(option + " is given twice");
    }
  }
  if (given.count("--bridge") != given.count("--world")) {
    refuse("--bridge and --world belong together");
  }
  CommandLine command;
  for (const char* option : {"--suite", "--results"}) {
    if (given.count(option) == 0) {
      refuse(std::string(option) + " is missing");
    }
  }
  command.suite = given["--suite"];
  command.results = given["--results"];
  if (given.count("--bridge") > 0) {
    command.bridge = given["--bridge"];
    command.world = given["--world"];
  }
  command.seed = number(given, "--seed", 1);
  constexpr std::uint64_t most = std::numeric_limits<int>::max();
  command.from = static_cast<int>(std::min(number(given, "--from", 0), most));
  if (given.count("--recording") > 0) {
    command.recording = given["--recording"];
  }
  command.caseTime = seconds(given, "--case-sim");
  command.repetition = repetitionOf(given);
  return command;
}

}  // namespace sitaf::runtime
