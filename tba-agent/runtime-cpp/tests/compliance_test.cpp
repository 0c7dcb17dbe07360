#include <doctest/doctest.h>

#include <array>
#include <fstream>
#include <functional>
#include <map>

#include "sitaf/suite/answer.hpp"
#include "sitaf/suite/case_result.hpp"

// The tables of tests/compliance that every runtime runs: literals, answers of stubs, texts.

using sitaf::suite::CaseDataError;
using sitaf::suite::CaseResult;
using sitaf::suite::TestCase;
using sitaf::suite::valueOf;
namespace literals = sitaf::suite::literals;

namespace compliance {

struct Point {
  double x = 0;
  double y = 0;
};

enum class Mode { slow, fast };

}  // namespace compliance

template <>
struct sitaf::suite::Structure<compliance::Point> {
  template <class Value, class Visit>
  static void each(Value& value, Visit visit) {
    visit("x", value.x);
    visit("y", value.y);
  }
};

template <>
struct sitaf::suite::Enumeration<compliance::Mode> {
  static constexpr std::array<std::pair<std::string_view, compliance::Mode>, 2> literals = {
      {{"SLOW", compliance::Mode::slow}, {"FAST", compliance::Mode::fast}}};
};

namespace {

using Row = std::vector<std::string>;

std::vector<Row> rows(const std::string& table) {
  std::ifstream file(std::string(SITAF_COMPLIANCE) + "/" + table);
  std::vector<Row> result;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line.front() == '#') {
      continue;
    }
    Row row{""};
    for (const char c : line) {
      if (c == '\t') {
        row.emplace_back();
      } else {
        row.back() += c;
      }
    }
    result.push_back(row);
  }
  REQUIRE(!result.empty());
  return result;
}

template <class T>
std::string readAndWritten(const std::string& literal) {
  return literals::write(valueOf(literals::read<T>(literal)));
}

using ReadAndWrite = std::function<std::string(const std::string&)>;

template <class T>
void add(std::map<std::string, ReadAndWrite>& types, const std::string& name) {
  types[name] = &readAndWritten<T>;
  types["sequence<" + name + ">"] = &readAndWritten<std::vector<T>>;
}

std::map<std::string, ReadAndWrite> allTypes() {
  std::map<std::string, ReadAndWrite> types;
  add<std::int8_t>(types, "int8");
  add<std::int16_t>(types, "int16");
  add<std::int32_t>(types, "int32");
  add<std::int64_t>(types, "int64");
  add<std::uint64_t>(types, "uint64");
  add<double>(types, "double");
  add<float>(types, "float");
  add<bool>(types, "boolean");
  add<char>(types, "char");
  add<std::string>(types, "string");
  add<compliance::Mode>(types, "Mode");
  add<compliance::Point>(types, "Point");
  return types;
}

void appendUtf8(std::string& text, unsigned code) {
  if (code < 0x80) {
    text += static_cast<char>(code);
  } else if (code < 0x800) {
    text += static_cast<char>(0xC0U | code >> 6U);
    text += static_cast<char>(0x80U | (code & 0x3FU));
  } else {
    text += static_cast<char>(0xE0U | code >> 12U);
    text += static_cast<char>(0x80U | (code >> 6U & 0x3FU));
    text += static_cast<char>(0x80U | (code & 0x3FU));
  }
}

std::string unescaped(const std::string& text) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    if (text.compare(i, 2, "\\u") == 0) {
      appendUtf8(result, static_cast<unsigned>(std::stoul(text.substr(i + 2, 4), nullptr, 16)));
      i += 6;
    } else {
      result += text[i++];
    }
  }
  return result;
}

TestCase caseOf(const std::string& literal) {
  return TestCase(1, true, std::make_shared<const std::vector<std::string>>(std::vector<std::string>{"answer"}), {literal});
}

template <class T>
void checkAnswer(const Row& row) {
  const TestCase testCase = caseOf(row[1]);
  std::string message;
  try {
    const auto answer = sitaf::suite::answer<T>(testCase, "answer");
    CHECK(answer.delay == std::stod(row[2]));
    CHECK((answer.error.empty() ? "-" : answer.error) == row[3]);
    CHECK((answer.error.empty() ? literals::write(valueOf(answer.value)) : "-") == row[4]);
  } catch (const CaseDataError& e) {
    message = e.what();
  }
  const std::string prefix = "answer: ";
  CHECK((message.compare(0, prefix.size(), prefix) == 0 ? message.substr(prefix.size()) : message) == row[5]);
}

}  // namespace

TEST_CASE("literals are read and written") {
  const auto types = allTypes();
  for (const Row& row : rows("literals.tsv")) {
    CAPTURE(row[0]);
    CAPTURE(row[1]);
    std::string recorded;
    std::string message;
    try {
      recorded = types.at(row[0])(row[1]);
    } catch (const CaseDataError& e) {
      message = e.what();
    }
    CHECK(recorded == row[2]);
    CHECK(message == row[3]);
  }
}

TEST_CASE("answers are read") {
  for (const Row& row : rows("answers.tsv")) {
    CAPTURE(row[1]);
    if (row[0] == "double") {
      checkAnswer<double>(row);
    } else if (row[0] == "int32") {
      checkAnswer<std::int32_t>(row);
    } else if (row[0] == "string") {
      checkAnswer<std::string>(row);
    } else {
      REQUIRE(row[0] == "Point");
      checkAnswer<compliance::Point>(row);
    }
  }
}

TEST_CASE("texts are written to the record") {
  for (const Row& row : rows("texts.tsv")) {
    const TestCase testCase = caseOf("");
    CaseResult result(testCase);
    result.record("return", unescaped(row[0]));
    CHECK(result.line() == "<case_record no=\"1\" outcome=\"RETURNED\"><actual name=\"return\">" + row[1] + "</actual></case_record>\n");
  }
}
