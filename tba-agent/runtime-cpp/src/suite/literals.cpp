#include "sitaf/suite/literals.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>

namespace sitaf::suite::literals {
namespace {

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

/// No integer type holds more digits.
constexpr long maxDigits = 30;

/// The digits of an integer without its sign. It may be written as 7, 7.0 or 7e2.
std::string wholeDigits(std::string_view literal, bool& negative) {
  std::string_view text = stripped(literal);
  negative = !text.empty() && text.front() == '-';
  if (!text.empty() && (text.front() == '-' || text.front() == '+')) {
    text.remove_prefix(1);
  }
  std::string digits;
  long exponent = 0;
  bool fraction = false;
  std::size_t i = 0;
  for (; i < text.size() && (text[i] == '.' || (text[i] >= '0' && text[i] <= '9')); ++i) {
    if (text[i] == '.') {
      if (fraction) {
        refuse(literal, "is not a number");
      }
      fraction = true;
    } else {
      digits += text[i];
      exponent -= fraction ? 1 : 0;
    }
  }
  if (digits.empty()) {
    refuse(literal, "is not a number");
  }
  if (i < text.size()) {
    const char* from = text.data() + i + 1;
    const char* end = text.data() + text.size();
    from += from != end && *from == '+' ? 1 : 0;
    long given = 0;
    const auto [stop, problem] = std::from_chars(from, end, given);
    if ((text[i] != 'e' && text[i] != 'E') || problem != std::errc() || stop != end) {
      refuse(literal, "is not a number");
    }
    exponent += given;
  }
  digits.erase(0, digits.find_first_not_of('0'));
  if (digits.empty()) {
    return "0";
  }
  for (; exponent < 0; ++exponent) {
    if (digits.empty() || digits.back() != '0') {
      refuse(literal, "is not a whole number");
    }
    digits.pop_back();
  }
  // A number with more digits is out of range anyway, and expanding 1e999999999 would exhaust memory.
  digits.append(static_cast<std::size_t>(std::min(exponent, maxDigits)), '0');
  return digits;
}

std::string quoted(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      result += '\\';
    }
    result += c;
  }
  return result + '"';
}

/// A part of a sequence or a struct: the text between two commas of the outermost level.
struct Part {
  std::string text;
  /// Position of the colon of a member; npos without one.
  std::size_t colon = std::string::npos;
  bool quoted = false;
};

std::vector<Part> partsOf(std::string_view literal, char open, char close, const char* example) {
  const std::string_view text = stripped(literal);
  if (text.size() < 2 || text.front() != open || text.back() != close) {
    refuse(literal, std::string("is not a ") + example);
  }
  std::vector<Part> parts;
  Part part;
  int depth = 0;
  bool inQuotes = false;
  for (std::size_t i = 1; i + 1 < text.size(); ++i) {
    const char c = text[i];
    if (inQuotes) {
      if (c == '\\' && i + 2 < text.size()) {
        // Within a nested part the escape is resolved when that part is read.
        if (depth > 0 || part.colon != std::string::npos) {
          part.text += c;
        }
        part.text += text[++i];
        continue;
      }
      if (c == '"') {
        inQuotes = false;
        if (depth == 0 && part.colon == std::string::npos) {
          continue;
        }
      }
      part.text += c;
    } else if (c == '"') {
      inQuotes = true;
      if (depth > 0 || part.colon != std::string::npos) {
        part.text += c;
      } else {
        part.quoted = true;
        part.text = std::string(stripped(part.text));
      }
    } else if (c == ',' && depth == 0) {
      parts.push_back(part);
      part = Part();
    } else {
      depth += c == '[' || c == '{' ? 1 : 0;
      depth -= c == ']' || c == '}' ? 1 : 0;
      if (c == ':' && depth == 0 && part.colon == std::string::npos && open == '{') {
        part.colon = part.text.size();
      }
      if (!(part.quoted && depth == 0 && isBlank(c))) {
        part.text += c;
      }
    }
  }
  if (inQuotes) {
    refuse(literal, "has a quote that is not closed");
  }
  if (!parts.empty() || part.quoted || !stripped(part.text).empty()) {
    parts.push_back(part);
  }
  return parts;
}

std::string unquoted(std::string_view text) {
  if (text.size() < 2 || text.front() != '"' || text.back() != '"') {
    return std::string(text);
  }
  std::string result;
  for (std::size_t i = 1; i + 1 < text.size(); ++i) {
    if (text[i] == '\\' && i + 2 < text.size()) {
      ++i;
    }
    result += text[i];
  }
  return result;
}

/// The shortest text that is read back as the same number: in decimal notation from 1e-3 to below 1e7, otherwise with an exponent.
template <class Number>
std::string shortest(Number number) {
  if (std::isnan(number)) {
    return "NaN";
  }
  if (std::isinf(number)) {
    return number > 0 ? "Infinity" : "-Infinity";
  }
  char buffer[64];
  const double size = std::abs(static_cast<double>(number));
  if (size == 0 || (size >= 1e-3 && size < 1e7)) {
    std::string text(buffer, std::to_chars(buffer, buffer + sizeof buffer, number, std::chars_format::fixed).ptr);
    return text.find('.') == std::string::npos ? text + ".0" : text;
  }
  const std::string text(buffer, std::to_chars(buffer, buffer + sizeof buffer, number, std::chars_format::scientific).ptr);
  const std::size_t mark = text.find('e');
  const std::string digits = text.substr(0, mark);
  const std::string sign = text[mark + 1] == '-' ? "-" : "";
  const std::string exponent = text.substr(text.find_first_not_of("+-0", mark + 1));
  return digits + (digits.find('.') == std::string::npos ? ".0E" : "E") + sign + exponent;
}

}  // namespace

std::string_view stripped(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r\n");
  return first == std::string_view::npos ? std::string_view() : text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

void refuse(std::string_view literal, std::string_view problem) {
  throw CaseDataError("'" + std::string(literal) + "' " + std::string(problem));
}

double real(std::string_view literal) {
  const std::string_view text = stripped(literal);
  std::string lower(text);
  for (char& c : lower) {
    c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  if (lower == "nan" || lower == ".nan") {
    return std::numeric_limits<double>::quiet_NaN();
  }
  if (lower == "infinity" || lower == "+infinity" || lower == "inf" || lower == "+inf" || lower == ".inf") {
    return std::numeric_limits<double>::infinity();
  }
  if (lower == "-infinity" || lower == "-inf" || lower == "-.inf") {
    return -std::numeric_limits<double>::infinity();
  }
  const char* from = lower.data() + (!lower.empty() && lower.front() == '+' ? 1 : 0);
  const char* end = lower.data() + lower.size();
  double number = 0;
  const auto [stop, problem] = std::from_chars(from, end, number);
  if (problem == std::errc::result_out_of_range && stop == end) {
    // Too large or too small; strtod returns infinity or zero. The locale does not matter for a number that is out of range.
    return std::strtod(lower.c_str(), nullptr);
  }
  if (problem != std::errc() || stop != end || lower.find_first_of("in") != std::string::npos || lower.compare(0, 2, "+-") == 0) {
    refuse(literal, "is not a number");
  }
  return number;
}

std::int64_t whole(std::string_view literal, std::int64_t min, std::int64_t max) {
  bool negative = false;
  const std::string digits = wholeDigits(literal, negative);
  const std::string text = (negative ? "-" : "") + digits;
  std::int64_t number = 0;
  const auto problem = std::from_chars(text.data(), text.data() + text.size(), number).ec;
  if (problem != std::errc() || number < min || number > max) {
    throw CaseDataError(std::string(literal) + " is outside of " + std::to_string(min) + " to " + std::to_string(max));
  }
  return number;
}

std::uint64_t natural(std::string_view literal, std::uint64_t max) {
  bool negative = false;
  const std::string digits = wholeDigits(literal, negative);
  std::uint64_t number = 0;
  const auto problem = std::from_chars(digits.data(), digits.data() + digits.size(), number).ec;
  if (problem != std::errc() || (negative && number != 0) || number > max) {
    throw CaseDataError(std::string(literal) + " is outside of 0 to " + std::to_string(max));
  }
  return number;
}

bool boolean(std::string_view literal) {
  const std::string_view text = stripped(literal);
  if (text == "true" || text == "1") {
    return true;
  }
  if (text == "false" || text == "0") {
    return false;
  }
  refuse(literal, "is neither true nor false");
}

char character(std::string_view literal) {
  if (literal.size() != 1) {
    refuse(literal, "is not one character");
  }
  return literal.front();
}

std::vector<std::string> elements(std::string_view literal) {
  std::vector<std::string> result;
  for (const Part& part : partsOf(literal, '[', ']', "sequence such as [1, 2]")) {
    result.push_back(part.quoted ? part.text : std::string(stripped(part.text)));
  }
  return result;
}

std::vector<std::pair<std::string, std::string>> members(std::string_view literal) {
  std::vector<std::pair<std::string, std::string>> result;
  for (const Part& part : partsOf(literal, '{', '}', "struct such as {x: 1.0, y: 2.0}")) {
    if (part.colon == std::string::npos) {
      refuse(literal, "has a member without a name");
    }
    const std::string_view text = part.text;
    result.emplace_back(std::string(stripped(text.substr(0, part.colon))), unquoted(stripped(text.substr(part.colon + 1))));
  }
  return result;
}

std::string write(double number) { return shortest(number); }

std::string write(float number) { return shortest(number); }

namespace {

std::string inner(const Value& value) {
  const auto* text = std::get_if<std::string>(&value.content());
  return text != nullptr ? quoted(*text) : write(value);
}

}  // namespace

std::string write(const Value& value) {
  return std::visit(
      [](const auto& content) -> std::string {
        using T = std::decay_t<decltype(content)>;
        if constexpr (std::is_same_v<T, bool>) {
          return content ? "true" : "false";
        } else if constexpr (std::is_integral_v<T>) {
          return std::to_string(content);
        } else if constexpr (std::is_floating_point_v<T>) {
          return shortest(content);
        } else if constexpr (std::is_same_v<T, std::string>) {
          return content;
        } else if constexpr (std::is_same_v<T, Value::Literal>) {
          return content.name;
        } else if constexpr (std::is_same_v<T, Value::Elements>) {
          std::string text = "[";
          for (std::size_t i = 0; i < content.size(); ++i) {
            text += (i == 0 ? "" : ", ") + inner(content[i]);
          }
          return text + "]";
        } else {
          std::string text = "{";
          for (std::size_t i = 0; i < content.size(); ++i) {
            text += (i == 0 ? "" : ", ") + content[i].first + ": " + inner(content[i].second);
          }
          return text + "}";
        }
      },
      value.content());
}

}  // namespace sitaf::suite::literals
