#include <doctest/doctest.h>
#include <fcntl.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "sitaf/runtime/component.hpp"
#include "sitaf/suite/case_result.hpp"
#include "suite/comparison.hpp"
#include "suite/results_file.hpp"
#include "suite/suite_reader.hpp"

using sitaf::suite::CaseDataError;
using sitaf::suite::CaseResult;
using sitaf::suite::difference;
using sitaf::suite::TestCase;
using sitaf::suite::Tolerance;
using sitaf::suite::valueOf;
using sitaf::suite::Verdict;
namespace literals = sitaf::suite::literals;

namespace {

struct Point {
  double x = 0;
  double y = 0;
};

enum class Mode { slow, fast };

TestCase oneCase(std::vector<std::string> names, std::vector<std::string> values, TestCase::Expectations expected) {
  return TestCase(7, true, std::make_shared<const std::vector<std::string>>(std::move(names)), std::move(values), std::move(expected));
}

std::string write(const std::string& text) {
  std::string path = "/tmp/sitaf-suite-XXXXXX";
  ::close(::mkstemp(path.data()));
  std::ofstream(path) << text;
  return path;
}

}  // namespace

template <>
struct sitaf::suite::Structure<Point> {
  template <class Value, class Visit>
  static void each(Value& value, Visit visit) {
    visit("x", value.x);
    visit("y", value.y);
  }
};

template <>
struct sitaf::suite::Enumeration<Mode> {
  static constexpr std::array<std::pair<std::string_view, Mode>, 2> literals = {{{"SLOW", Mode::slow}, {"FAST", Mode::fast}}};
};

TEST_CASE("numbers compare as numbers") {
  CHECK(difference("-1", valueOf(-1.0), {}).empty());
  CHECK(difference("7.0", valueOf(7), {}).empty());
  CHECK(difference("0.1", valueOf(0.1F), {}).empty());
  CHECK(difference("NaN", valueOf(std::nan("")), {}).empty());
  CHECK(difference("18446744073709551615", valueOf(std::numeric_limits<std::uint64_t>::max()), {}).empty());
  CHECK(difference("9223372036854775807", valueOf(std::int64_t{9223372036854775806}), {}) ==
        "expected 9223372036854775807, but was 9223372036854775806");
  CHECK(difference("3.0", valueOf(3.5), {}) == "expected 3.0, but was 3.5");
  CHECK_FALSE(difference("Infinity", valueOf(1e308), Tolerance{1e308, 1, 0}).empty());
  CHECK_THROWS_AS(difference("abc", valueOf(1.0), {}), CaseDataError);
}

TEST_CASE("a tolerance is absolute, relative, or counted in units of the last place") {
  CHECK(difference("1.0", valueOf(1.0 + 1e-9), Tolerance{1e-8, 0, 0}).empty());
  CHECK(difference("100", valueOf(101.0), Tolerance{0, 0.01, 0}).empty());
  const double next = std::nextafter(1.0, 2.0);
  CHECK_FALSE(difference("1.0", valueOf(next), {}).empty());
  CHECK(difference("1.0", valueOf(next), Tolerance{0, 0, 1}).empty());
  CHECK_FALSE(difference("1.0", valueOf(std::nextafter(next, 2.0)), Tolerance{0, 0, 1}).empty());
  CHECK(difference("-0.0", valueOf(std::nextafter(0.0, 1.0)), Tolerance{0, 0, 1}).empty());
  CHECK(difference("1.0", valueOf(std::nextafter(next, 2.0)), Tolerance{0, 0, 2.5}).empty());
  CHECK(difference("1.0", valueOf(std::nextafter(next, 2.0)), Tolerance{2.3e-16, 0, 1}).empty());
  CHECK(difference("1.0", valueOf(std::nextafterf(1.0F, 2.0F)), Tolerance{0, 0, 1}).empty());
}

TEST_CASE("a difference inside names its place") {
  CHECK(difference("[1.0, 2.0]", valueOf(std::vector<double>{1, 2.5}), {}) == "[1]: expected 2.0, but was 2.5");
  CHECK(difference("[1]", valueOf(std::vector<int>{}), {}) == "expected 1 elements, but there are 0");
  CHECK(difference("{x: 1.0, y: 2.0}", valueOf(Point{1, 3}), {}) == "y: expected 2.0, but was 3.0");
  CHECK(difference("[{x: 1, y: 2}, {x: 3, y: 4}]", valueOf(std::vector<Point>{{1, 2}, {9, 4}}), {}) == "[1].x: expected 3, but was 9.0");
  CHECK(difference("SLOW", valueOf(Mode::fast), {}) == "expected 'SLOW', but was 'FAST'");
}

TEST_CASE("values are spelled as they are read") {
  const std::vector<std::string> texts{"a", "b, \"c\"", "[d]", "\\", ""};
  CHECK(literals::read<std::vector<std::string>>(literals::spelling(valueOf(texts))) == texts);
  const std::vector<Point> points{{1.5, -2}, {0.1, 1e300}};
  const auto again = literals::read<std::vector<Point>>(literals::spelling(valueOf(points)));
  REQUIRE(again.size() == 2);
  CHECK(again[1].y == 1e300);
  CHECK(literals::spelling(valueOf(points)) == "[{x: 1.5, y: -2.0}, {x: 0.1, y: 1e+300}]");
  CHECK(literals::read<Mode>("FAST") == Mode::fast);
  CHECK(literals::read<std::vector<bool>>("[true, false]") == std::vector<bool>{true, false});
  CHECK(literals::spelling(valueOf(std::numeric_limits<double>::infinity())) == "Infinity");
}

TEST_CASE("what a type cannot hold is refused") {
  CHECK(literals::read<std::uint8_t>("255") == 255);
  CHECK(literals::read<int>("7e2") == 700);
  CHECK_THROWS_AS(literals::read<std::uint8_t>("256"), CaseDataError);
  CHECK_THROWS_AS(literals::read<std::uint8_t>("-1"), CaseDataError);
  CHECK_THROWS_AS(literals::read<int>("1.5"), CaseDataError);
  CHECK_THROWS_AS(literals::read<char>("ab"), CaseDataError);
  CHECK_THROWS_AS(literals::read<bool>("yes"), CaseDataError);
  CHECK_THROWS_AS((literals::read<std::array<int, 2>>("[1]")), CaseDataError);
  CHECK_THROWS_AS(literals::read<Mode>("slow"), CaseDataError);
  CHECK_THROWS_AS(literals::read<std::vector<std::string>>("[\"a]"), CaseDataError);
}

TEST_CASE("a result is one line, whatever is in it") {
  const TestCase testCase = oneCase({"text"}, {"<&\n\"\x01\xff\xc3\xbc\xe2\x80\xa8"}, {{"", "2.0"}});
  CaseResult result(testCase);
  result.compare("return", 3.0, {});
  result.took(1.5, 0.25, 0);
  CHECK(result.line() ==
        "<test_result no=\"7\" verdict=\"FAIL\"><value>&lt;&amp;&#10;&quot;\\u0001\\u00FF\xc3\xbc&#8232;</value>"
        "<expected>2.0</expected><actual>3.0</actual><processing_time unit=\"us\" hardware=\"0.250\" stub=\"0.000\">1.500</processing_time>"
        "<message>expected 2.0, but was 3.0</message></test_result>\n");
}

TEST_CASE("an expected value that nobody compares makes an error") {
  const TestCase testCase = oneCase({}, {}, {{"speed", "2.0"}});
  CaseResult result(testCase);
  result.record("return", 3.0);
  CHECK(result.line().find("verdict=\"ERROR\"") != std::string::npos);
}

TEST_CASE("an expected error passes, and its absence fails") {
  const TestCase testCase = oneCase({}, {}, {{"", "!error:NoEcho"}});
  CaseResult thrown(testCase);
  CHECK(thrown.threw("NoEcho"));
  CHECK(thrown.line().find("verdict=\"PASS\"") != std::string::npos);
  CaseResult other(testCase);
  CHECK_FALSE(other.threw("OutOfReach"));
  CaseResult returned(testCase);
  returned.compare("return", 3.0, {});
  CHECK(returned.line().find("expected the error NoEcho, but it returned 3.0") != std::string::npos);
}

TEST_CASE("a suite is read case by case, and ahead") {
  const std::string path = write(
      "<test_suite_data><name>n</name><case_param_info><param name=\"a\" type=\"TDI\" real_type=\"int\"/></case_param_info><case_list>"
      "<case no=\"3\" class=\"valid\"><value>1</value><expected>5</expected></case>"
      "<case no=\"4\" class=\"invalid\"><value>x &amp; y</value></case></case_list></test_suite_data>");
  sitaf::suite::SuiteReader reader(path);
  REQUIRE(reader.next());
  CHECK(reader.current().no() == 3);
  CHECK(reader.current().value<int>("a") == 1);
  CHECK(*reader.current().expected("anything") == "5");
  REQUIRE(reader.peek(1) != nullptr);
  CHECK(reader.peek(1)->literal("a") == "x & y");
  CHECK(reader.peek(2) == nullptr);
  REQUIRE(reader.next());
  CHECK_FALSE(reader.current().valid());
  CHECK_THROWS_WITH_AS(reader.current().value<int>("b"), doctest::Contains("no parameter 'b'"), CaseDataError);
  CHECK_FALSE(reader.next());
  std::remove(path.c_str());
}

TEST_CASE("a document that is no suite is refused") {
  for (const char* text :
       {"<!DOCTYPE a [<!ENTITY x \"y\">]><test_suite_data><case_list/></test_suite_data>", "<other/>", "<test_suite_data/>", "nonsense",
        "<test_suite_data><param name=\"a\"/><param name=\"a\"/><case_list/></test_suite_data>"}) {
    const std::string path = write(text);
    CHECK_THROWS_AS(sitaf::suite::SuiteReader{path}, CaseDataError);
    std::remove(path.c_str());
  }
  const std::string path = write("<test_suite_data><param name=\"a\"/><case_list><case no=\"1\"/></case_list></test_suite_data>");
  sitaf::suite::SuiteReader reader(path);
  CHECK_THROWS_WITH_AS(reader.next(), doctest::Contains("0 values for 1 parameters"), CaseDataError);
  std::remove(path.c_str());
}

TEST_CASE("through a descriptor each line begins with its number and the token") {
  int input[2];
  int results[2];
  REQUIRE(::pipe(input) == 0);
  REQUIRE(::pipe(results) == 0);
  REQUIRE(::write(input[1], "secret\nrest", 11) == 11);
  ::close(input[1]);
  const int standardInput = ::dup(STDIN_FILENO);
  ::dup2(input[0], STDIN_FILENO);
  const TestCase testCase = oneCase({}, {}, {});
  {
    sitaf::suite::ResultsFile file("fd:" + std::to_string(results[1]), true);
    CaseResult result(testCase);
    file.ready();
    file.save(result);
    CHECK(::fcntl(results[1], F_GETFD) < 0);
  }
  char text[200];
  const ssize_t length = ::read(results[0], text, sizeof text);
  CHECK(std::string(text, static_cast<std::size_t>(length)) ==
        "1 secret \n2 secret <test_result no=\"7\" verdict=\"PASS\"></test_result>\n");
  char rest[8];
  CHECK(::read(STDIN_FILENO, rest, sizeof rest) == 4);
  CHECK_THROWS_WITH_AS(sitaf::suite::ResultsFile("fd:" + std::to_string(results[0]), true), doctest::Contains("no line with its token"),
                       std::runtime_error);
  ::dup2(standardInput, STDIN_FILENO);
  for (const int open : {input[0], results[0], standardInput}) {
    ::close(open);
  }
}

TEST_CASE("a torn line is ended before results go on") {
  const std::string path = write("\n<test_result no=\"1\"");
  const TestCase testCase = oneCase({}, {}, {});
  {
    sitaf::suite::ResultsFile file(path, true);
    CaseResult result(testCase);
    file.save(result);
  }
  std::stringstream text;
  text << std::ifstream(path).rdbuf();
  CHECK(text.str() == "\n<test_result no=\"1\"\n<test_result no=\"7\" verdict=\"PASS\"></test_result>\n");
  std::remove(path.c_str());
}

namespace {

struct Finder {
  virtual ~Finder() = default;
};
struct Wheels {
  virtual ~Wheels() = default;
};

struct Nothing {};
struct Both {
  Both(Wheels& wheels, Finder* finder) : wheels_(&wheels), finder_(finder) {}
  explicit Both(Wheels& wheels) : wheels_(&wheels) {}
  Wheels* wheels_;
  Finder* finder_ = nullptr;
};
struct Shared {
  explicit Shared(std::shared_ptr<Finder> finder) : finder_(std::move(finder)) {}
  std::shared_ptr<Finder> finder_;
};

struct General {
  std::string heard;
  void setProperty(const std::string& name, const std::string& value) { heard += name + "=" + value; }
};
struct Particular {
  double gain = 0;
  void setGain(double value) { gain = value; }
};

struct Living {
  std::string life;
  void initialise() { life += "i"; }
  void start() { life += "s"; }
  void onStop() { life += "p"; }
};

}  // namespace

TEST_CASE("a component is made by the constructor that asks for the most") {
  Finder finder;
  Wheels wheels;
  CHECK(sitaf::runtime::createComponent<Nothing>(finder, wheels) != nullptr);
  const auto both = sitaf::runtime::createComponent<Both>(finder, wheels);
  CHECK(both->finder_ == &finder);
  CHECK(both->wheels_ == &wheels);
  CHECK(sitaf::runtime::createComponent<Both>(wheels)->finder_ == nullptr);
  CHECK(sitaf::runtime::createComponent<Shared>(finder)->finder_.get() == &finder);
}

TEST_CASE("a property is set by whichever setter there is") {
  General general;
  sitaf::runtime::setProperty(general, "Gain", "0.5", sitaf::runtime::NoSetter{});
  CHECK(general.heard == "Gain=0.5");
  Particular particular;
  sitaf::runtime::setProperty(particular, "Gain", "0.5", SITAF_SETTER(setGain));
  CHECK(particular.gain == 0.5);
  CHECK_THROWS_AS(sitaf::runtime::setProperty(particular, "Gain", "much", SITAF_SETTER(setGain)), std::invalid_argument);
}

TEST_CASE("a component is led through the life that it has") {
  Living living;
  sitaf::runtime::beginLife(living, {});
  sitaf::runtime::endLife(living, {});
  CHECK(living.life == "isp");
  Nothing nothing;
  sitaf::runtime::beginLife(nothing, {});
}

TEST_CASE("a method of an interface is no step in a component's life") {
  Living living;
  sitaf::runtime::beginLife(living, {"start"});
  sitaf::runtime::endLife(living, {"stop"});
  CHECK(living.life == "ip");
}

TEST_CASE("a data port is a method of its name, its getter or a member") {
  struct Sender {
    double speed() { return 1.5; }
    int getCount() { return 3; }
    std::vector<double> path{0.5};
  } sender;
  CHECK(sitaf::runtime::dataPort(sender, SITAF_METHOD(speed), SITAF_METHOD(getSpeed), SITAF_MEMBER(speed)) == 1.5);
  CHECK(sitaf::runtime::dataPort(sender, SITAF_METHOD(count), SITAF_METHOD(getCount), SITAF_MEMBER(count)) == 3);
  CHECK(sitaf::runtime::dataPort(sender, SITAF_METHOD(path), SITAF_METHOD(getPath), SITAF_MEMBER(path)).size() == 1);
}

TEST_CASE("a method that returns nothing can be expected to return, or to throw") {
  const auto judged = [](const std::string& expected) {
    const TestCase testCase = oneCase({}, {}, {{"", expected}});
    CaseResult result(testCase);
    result.returnedNothing("return");
    return result.line();
  };
  CHECK(judged("null").find("verdict=\"PASS\"") != std::string::npos);
  CHECK(judged("!error:TooFast").find("expected the error TooFast, but it returned</message>") != std::string::npos);
  CHECK(judged("!unevaluated: no such key").find("verdict=\"ERROR\"") != std::string::npos);
  CHECK(judged("3").find("nothing is returned, so that 3 cannot be expected") != std::string::npos);
}
