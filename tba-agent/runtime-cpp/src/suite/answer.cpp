#include "sitaf/suite/answer.hpp"

#include <charconv>
#include <cmath>

namespace sitaf::suite {
namespace {

constexpr std::string_view delayMark = "!delay:";
constexpr std::string_view errorMark = "!error:";

bool startsWith(std::string_view text, std::string_view mark) { return text.substr(0, mark.size()) == mark; }

}  // namespace

std::string_view readAnswer(std::string_view literal, double& delay, std::string& error, bool& hasValue) {
  std::string_view rest = literal;
  hasValue = true;
  if (startsWith(rest, delayMark)) {
    rest.remove_prefix(delayMark.size());
    const auto [end, problem] = std::from_chars(rest.data(), rest.data() + rest.size(), delay);
    rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
    if (problem != std::errc() || !std::isfinite(delay) || std::signbit(delay) || (!rest.empty() && rest.front() != ' ')) {
      literals::refuse(literal, "is not a delay such as !delay:0.5 or !delay:0.5 VALUE, in seconds");
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

}  // namespace sitaf::suite
