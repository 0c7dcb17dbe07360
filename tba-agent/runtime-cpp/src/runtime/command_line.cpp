#include "runtime/command_line.hpp"

#include <charconv>
#include <limits>
#include <map>

#include "sitaf/runtime/cannot_run.hpp"

namespace sitaf::runtime {
namespace {

[[noreturn]] void refuse(const std::string& problem) {
  throw CannotRun(problem +
                  "; usage: --suite FILE --results FILE [--bridge TARGET --world FILE.world.yaml] [--seed N] [--from NO] "
                  "[--recording FOLDER] [--case-sim SECONDS]");
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

}  // namespace

CommandLine CommandLine::parse(int argc, char** argv) {
  std::map<std::string, std::string> given;
  for (int i = 1; i < argc; i += 2) {
    const std::string option = argv[i];
    const bool known = option == "--suite" || option == "--results" || option == "--bridge" || option == "--world" || option == "--seed" ||
                       option == "--from" || option == "--recording" || option == "--case-sim";
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
  if (given.count("--case-sim") > 0) {
    const std::string& text = given["--case-sim"];
    double seconds = 0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), seconds);
    if (problem != std::errc() || end != text.data() + text.size() || !(seconds > 0) || seconds > 1e9) {
      refuse("--case-sim: '" + text + "' is not a number of seconds above 0");
    }
    command.caseTime = std::chrono::nanoseconds(static_cast<std::int64_t>(seconds * 1e9));
  }
  return command;
}

}  // namespace sitaf::runtime
