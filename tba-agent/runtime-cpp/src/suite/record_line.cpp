#include "suite/record_line.hpp"

#include <charconv>
#include <cstdint>
#include <cstdio>

namespace sitaf::suite {
namespace {

/// Maximum length of a message in bytes; messages of a component's exceptions may have any length.
constexpr std::size_t maxMessageLength = 8000;

std::string_view nameOf(Outcome outcome) {
  switch (outcome) {
    case Outcome::returned:
      return "RETURNED";
    case Outcome::threw:
      return "THREW";
    case Outcome::error:
      return "ERROR";
    case Outcome::notCalled:
      return "NOT_CALLED";
  }
  return "ERROR";
}

/// The character at a position and its length in bytes. For a byte that is not UTF-8, the value of the byte and length 0.
struct Character {
  std::uint32_t code;
  std::size_t length;
};

Character characterAt(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(at);
  if (first < 0x80) {
    return {first, 1};
  }
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || at + length > text.size()) {
    return {first, 0};
  }
  std::uint32_t code = first & (0xFFU >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(at + i) & 0xC0U) != 0x80U) {
      return {first, 0};
    }
    code = code << 6U | (byte(at + i) & 0x3FU);
  }
  const bool overlong = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
  return overlong || code > 0x10FFFF ? Character{first, 0} : Character{code, length};
}

/// Production Char of XML 1.0.
bool isXml(std::uint32_t c) { return (c >= 0x20 && c <= 0xD7FF) || (c >= 0xE000 && c <= 0xFFFD) || c >= 0x10000; }

}  // namespace

RecordLine::RecordLine(const TestStep& step, Outcome outcome, std::chrono::nanoseconds at) : root_("step_record") {
  xml_.reserve(512);
  xml_ += "<step_record no=\"" + std::to_string(step.no()) + "\" step=\"" + std::to_string(step.number()) + "\" name=\"";
  escape(step.name());
  xml_ += "\" outcome=\"";
  xml_ += nameOf(outcome);
  xml_ += "\" at_ns=\"" + std::to_string(at.count()) + "\">";
}

RecordLine::RecordLine(int no, Outcome outcome) : root_("case_record") {
  xml_.reserve(512);
  xml_ += "<case_record no=\"" + std::to_string(no) + "\" outcome=\"";
  xml_ += nameOf(outcome);
  xml_ += "\">";
}

void RecordLine::time(double component, double hardware, double stub) {
  const auto number = [this](double micros) {
    char buffer[64];
    xml_.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, micros, std::chars_format::fixed, 3).ptr);
  };
  xml_ += "<processing_time unit=\"us\" hardware=\"";
  number(hardware);
  xml_ += "\" stub=\"";
  number(stub);
  xml_ += "\">";
  number(component);
  xml_ += "</processing_time>";
}

void RecordLine::repeated(const std::vector<std::int64_t>& nanos, std::string_view differs) {
  xml_ += "<repeated_calls>";
  for (std::size_t i = 0; i < nanos.size(); ++i) {
    xml_ += (i == 0 ? "" : " ") + std::to_string(nanos[i]);
  }
  xml_ += "</repeated_calls>";
  if (!differs.empty()) {
    element("differs", "", differs);
  }
}

void RecordLine::calls(const StubCalls& calls) {
  for (const StubCall& call : calls.first) {
    xml_ += "<call method=\"";
    escape(call.method);
    xml_ += "\">";
    for (const auto& [name, literal] : call.arguments) {
      element("argument", name, literal);
    }
    xml_ += "</call>";
  }
  std::size_t all = 0;
  for (const auto& count : calls.counts) {
    all += count.second;
  }
  if (all > calls.first.size()) {
    element("calls_left_out", "", std::to_string(all - calls.first.size()));
  }
}

void RecordLine::port(const PortChanges& port) {
  xml_ += "<port name=\"";
  escape(port.signal);
  xml_ += "\" left_out=\"" + std::to_string(port.leftOut) + "\">";
  for (const auto& [time, literal] : port.changes) {
    xml_ += "<at ns=\"" + std::to_string(time.count()) + "\">";
    escape(literal);
    xml_ += "</at>";
  }
  xml_ += "</port>";
}

void RecordLine::message(std::string_view text) {
  if (text.size() <= maxMessageLength) {
    element("message", "", text);
    return;
  }
  std::size_t end = maxMessageLength;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) {
    --end;
  }
  element("message", "", std::string(text.substr(0, end)) + " ... (" + std::to_string(text.size()) + " bytes)");
}

std::string RecordLine::close() {
  xml_ += std::string("</") + root_ + ">\n";
  return std::move(xml_);
}

void RecordLine::element(std::string_view element, std::string_view name, std::string_view content) {
  xml_ += '<';
  xml_ += element;
  if (!name.empty()) {
    xml_ += " name=\"";
    escape(name);
    xml_ += '"';
  }
  xml_ += '>';
  escape(content);
  xml_ += "</";
  xml_ += element;
  xml_ += '>';
}

void RecordLine::escape(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const Character c = characterAt(text, at);
    switch (c.code) {
      case '&':
        xml_ += "&amp;";
        break;
      case '<':
        xml_ += "&lt;";
        break;
      case '>':
        xml_ += "&gt;";
        break;
      case '"':
        xml_ += "&quot;";
        break;
      // Also the line separators of Unicode, for readers that split lines at them.
      case '\n':
      case '\r':
      case '\t':
      case 0x2028:
      case 0x2029:
        xml_ += "&#" + std::to_string(c.code) + ";";
        break;
      default:
        if (c.length > 0 && c.code == 0x85) {
          xml_ += "&#133;";
        } else if (c.length > 0 && isXml(c.code)) {
          xml_ += text.substr(at, c.length);
        } else {
          char buffer[16];
          std::snprintf(buffer, sizeof buffer, "\\u%04X", static_cast<unsigned>(c.code));
          xml_ += buffer;
        }
    }
    at += c.length == 0 ? 1 : c.length;
  }
}

}  // namespace sitaf::suite
