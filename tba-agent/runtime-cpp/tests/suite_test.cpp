#include <doctest/doctest.h>
#include <fcntl.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>

#include "sitaf/runtime/component.hpp"
#include "sitaf/runtime/watched_ports.hpp"
#include "sitaf/suite/case_result.hpp"
#include "suite/results_file.hpp"
#include "suite/suite_reader.hpp"

using sitaf::suite::CaseDataError;
using sitaf::suite::CaseResult;
using sitaf::suite::TestCase;
using sitaf::suite::valueOf;
namespace literals = sitaf::suite::literals;

namespace {

struct Point {
  double x = 0;
  double y = 0;
};

enum class Mode { slow, fast };

TestCase oneCase(std::vector<std::string> names, std::vector<std::string> values) {
  return TestCase(7, true, std::make_shared<const std::vector<std::string>>(std::move(names)), std::move(values));
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

TEST_CASE("written values read back") {
  const std::vector<std::string> texts{"a", "b, \"c\"", "[d]", "\\", ""};
  CHECK(literals::read<std::vector<std::string>>(literals::write(valueOf(texts))) == texts);
  const std::vector<Point> points{{1.5, -2}, {0.1, 1e300}};
  const auto again = literals::read<std::vector<Point>>(literals::write(valueOf(points)));
  REQUIRE(again.size() == 2);
  CHECK(again[1].y == 1e300);
  CHECK(literals::write(valueOf(points)) == "[{x: 1.5, y: -2.0}, {x: 0.1, y: 1.0E300}]");
  CHECK(literals::read<Mode>("FAST") == Mode::fast);
  CHECK(literals::read<std::vector<bool>>("[true, false]") == std::vector<bool>{true, false});
  CHECK(literals::write(valueOf(std::numeric_limits<double>::infinity())) == "Infinity");
}

TEST_CASE("values that a type cannot hold are rejected") {
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

TEST_CASE("a record with any text is one line") {
  const TestCase testCase = oneCase({}, {});
  CaseResult result(testCase);
  result.record("return", std::string("<&\n\"\x01\xff\xc3\xbc\xe2\x80\xa8"));
  result.setTime(1.5, 0.25, 0);
  CHECK(result.line() ==
        "<case_record no=\"7\" outcome=\"RETURNED\"><actual name=\"return\">&lt;&amp;&#10;&quot;\\u0001\\u00FF\xc3\xbc&#8232;</actual>"
        "<processing_time unit=\"us\" hardware=\"0.250\" stub=\"0.000\">1.500</processing_time></case_record>\n");
}

TEST_CASE("a record of a step is one line") {
  const sitaf::suite::TestStep step(4, 2, "Read", true, std::make_shared<const std::vector<std::string>>(), {});
  CaseResult result(step);
  result.beganAt(std::chrono::milliseconds(100));
  result.record("return", 5);
  CHECK(result.line() ==
        "<step_record no=\"4\" step=\"2\" name=\"Read\" outcome=\"RETURNED\" at_ns=\"100000000\"><actual name=\"return\">5</actual>"
        "</step_record>\n");
}

TEST_CASE("repeated calls have times in nanoseconds and the first difference") {
  const TestCase testCase = oneCase({}, {});
  const auto called = [&testCase](int value, double micros) {
    CaseResult result(testCase);
    result.setTime(micros, 0, 0);
    result.record("return", value);
    return result;
  };
  CaseResult first = called(3, 370);
  CHECK(first.isRepeatable());
  first.beginRepeated();
  first.addRepeated(called(3, 9), 2, false);
  first.addRepeated(called(3, 4.125), 3, true);
  first.addRepeated(called(5, 6), 4, true);
  CaseResult thrown = called(3, 1);
  thrown.threw("NoEcho", "too far");
  first.addRepeated(thrown, 5, true);
  CHECK(first.line().find("<repeated_calls>4125 6000</repeated_calls><differs>call 4: return is 5, not 3</differs></case_record>") !=
        std::string::npos);

  CaseResult other = called(3, 370);
  other.beginRepeated();
  other.addRepeated(thrown, 2, true);
  CHECK(other.line().find("<repeated_calls></repeated_calls><differs>call 2: threw NoEcho, but the first call returned</differs>") !=
        std::string::npos);
  CaseResult failed(testCase);
  failed.endWith(sitaf::suite::Outcome::error, "no");
  CHECK_FALSE(failed.isRepeatable());
}

TEST_CASE("the type name of an exception is recorded") {
  const TestCase testCase = oneCase({}, {});
  CaseResult result(testCase);
  result.threw("NoEcho", "sitaf::interfaces::NoEcho: too far");
  CHECK(result.line() ==
        "<case_record no=\"7\" outcome=\"THREW\"><thrown>NoEcho</thrown><message>sitaf::interfaces::NoEcho: too "
        "far</message></case_record>\n");
}

TEST_CASE("a missing part is null, and so is the return of a void method") {
  const TestCase testCase = oneCase({}, {});
  CaseResult result(testCase);
  const std::vector<double> path{0.5};
  result.recordPart("path[0]", [&] { return path.at(0); });
  result.recordPart("path[1]", [&] { return path.at(1); });
  result.recordReturn("return");
  CHECK(result.line() ==
        "<case_record no=\"7\" outcome=\"RETURNED\"><actual name=\"path[0]\">0.5</actual><actual name=\"path[1]\">null</actual>"
        "<actual name=\"return\">null</actual></case_record>\n");
}

TEST_CASE("the steps of a sequence are read") {
  const std::string head =
      "<test_suite_data><case_param_info><param name=\"a\"/></case_param_info><step_param_info><step name=\"Read\"><param "
      "name=\"i\"/></step>"
      "<step name=\"Nears\"/></step_param_info><case_list><case no=\"4\"><value>5</value><step name=\"Read\" class=\"invalid\">";
  const std::string tail = "<expected>0</expected></step><step name=\"Nears\"/></case></case_list></test_suite_data>";
  sitaf::suite::SuiteReader reader(write(head + "<value>-1</value>" + tail));
  REQUIRE(reader.next());
  CHECK(reader.current().value<int>("a") == 5);
  const std::vector<sitaf::suite::TestStep>& steps = reader.current().steps();
  REQUIRE(steps.size() == 2);
  CHECK(steps[0].name() == "Read");
  CHECK(steps[0].number() == 1);
  CHECK(!steps[0].valid());
  CHECK(steps[0].value<int>("i") == -1);
  CHECK(steps[1].name() == "Nears");
  CHECK(steps[1].valid());
  sitaf::suite::SuiteReader incomplete(write(head + tail));
  CHECK_THROWS_WITH_AS(incomplete.next(), doctest::Contains("step 1 (Read) of case 4 has 0 values for 1 parameters"), CaseDataError);
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
  REQUIRE(reader.peek(1) != nullptr);
  CHECK(reader.peek(1)->literal("a") == "x & y");
  CHECK(reader.peek(2) == nullptr);
  REQUIRE(reader.next());
  CHECK_FALSE(reader.current().valid());
  CHECK_THROWS_WITH_AS(reader.current().value<int>("b"), doctest::Contains("no parameter 'b'"), CaseDataError);
  CHECK_FALSE(reader.next());
  std::remove(path.c_str());
}

TEST_CASE("a document that is no suite is rejected") {
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

TEST_CASE("lines on a descriptor start with number and token") {
  int input[2];
  int results[2];
  REQUIRE(::pipe(input) == 0);
  REQUIRE(::pipe(results) == 0);
  REQUIRE(::write(input[1], "secret\nrest", 11) == 11);
  ::close(input[1]);
  const int standardInput = ::dup(STDIN_FILENO);
  ::dup2(input[0], STDIN_FILENO);
  const TestCase testCase = oneCase({}, {});
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
        "1 secret \n2 secret <case_record no=\"7\" outcome=\"RETURNED\"></case_record>\n");
  char rest[8];
  CHECK(::read(STDIN_FILENO, rest, sizeof rest) == 4);
  CHECK_THROWS_WITH_AS(sitaf::suite::ResultsFile("fd:" + std::to_string(results[0]), true), doctest::Contains("no line with its token"),
                       std::runtime_error);
  ::dup2(standardInput, STDIN_FILENO);
  for (const int open : {input[0], results[0], standardInput}) {
    ::close(open);
  }
}

TEST_CASE("an incomplete line is terminated before results are appended") {
  const std::string path = write("\n<case_record no=\"1\"");
  const TestCase testCase = oneCase({}, {});
  {
    sitaf::suite::ResultsFile file(path, true);
    CaseResult result(testCase);
    file.save(result);
  }
  std::stringstream text;
  text << std::ifstream(path).rdbuf();
  CHECK(text.str() == "\n<case_record no=\"1\"\n<case_record no=\"7\" outcome=\"RETURNED\"></case_record>\n");
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
  std::string received;
  void setProperty(const std::string& name, const std::string& value) { received += name + "=" + value; }
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

TEST_CASE("a component is created by the constructor with the most parameters") {
  Finder finder;
  Wheels wheels;
  CHECK(sitaf::runtime::createComponent<Nothing>(finder, wheels) != nullptr);
  const auto both = sitaf::runtime::createComponent<Both>(finder, wheels);
  CHECK(both->finder_ == &finder);
  CHECK(both->wheels_ == &wheels);
  CHECK(sitaf::runtime::createComponent<Both>(wheels)->finder_ == nullptr);
  CHECK(sitaf::runtime::createComponent<Shared>(finder)->finder_.get() == &finder);
}

TEST_CASE("a property is set by the general setter or its own") {
  General general;
  sitaf::runtime::setProperty(general, "Gain", "0.5", sitaf::runtime::NoSetter{});
  CHECK(general.received == "Gain=0.5");
  Particular particular;
  sitaf::runtime::setProperty(particular, "Gain", "0.5", SITAF_SETTER(setGain));
  CHECK(particular.gain == 0.5);
  CHECK_THROWS_AS(sitaf::runtime::setProperty(particular, "Gain", "much", SITAF_SETTER(setGain)), std::invalid_argument);
}

TEST_CASE("the life-cycle methods of a component are called") {
  Living living;
  sitaf::runtime::beginLife(living, {});
  sitaf::runtime::endLife(living, {});
  CHECK(living.life == "isp");
  Nothing nothing;
  sitaf::runtime::beginLife(nothing, {});
}

TEST_CASE("a method of an interface is no life-cycle method") {
  Living living;
  sitaf::runtime::beginLife(living, {"start"});
  sitaf::runtime::endLife(living, {"stop"});
  CHECK(living.life == "ip");
}

TEST_CASE("a data port is read from a method, a getter or a member") {
  struct Sender {
    double speed() { return 1.5; }
    int getCount() { return 3; }
    std::vector<double> path{0.5};
  } sender;
  CHECK(sitaf::runtime::dataPort(sender, SITAF_METHOD(speed), SITAF_METHOD(getSpeed), SITAF_MEMBER(speed)) == 1.5);
  CHECK(sitaf::runtime::dataPort(sender, SITAF_METHOD(count), SITAF_METHOD(getCount), SITAF_MEMBER(count)) == 3);
  CHECK(sitaf::runtime::dataPort(sender, SITAF_METHOD(path), SITAF_METHOD(getPath), SITAF_MEMBER(path)).size() == 1);
}

TEST_CASE("only changes of a watched port are recorded, with the last value of each time") {
  using std::chrono::nanoseconds;
  sitaf::runtime::WatchedPorts ports;
  std::vector<std::string> values{"0.0", "0.0", "1.0", "2.0", "2.0", "0.0"};
  std::size_t at = 0;
  ports.watch(
      "speed", [&] { return values.at(at++); }, nanoseconds(10));
  for (const int now : {20, 30, 30, 40, 50}) {
    ports.take(nanoseconds(now));
  }
  ports.requireRead();
  const sitaf::suite::TestCase testCase = oneCase({}, {});
  sitaf::suite::CaseResult result(testCase);
  ports.writeTo(result, nanoseconds(30));
  CHECK(
      result.line().find("<port name=\"speed\" left_out=\"0\"><at ns=\"-20\">0.0</at><at ns=\"0\">2.0</at><at ns=\"20\">0.0</at></port>") !=
      std::string::npos);
  // What the port throws is thrown later, because the component may be running.
  ports.take(nanoseconds(60));
  CHECK_THROWS_AS(ports.requireRead(), std::out_of_range);
  ports.clear();
  ports.take(nanoseconds(70));
  ports.requireRead();
}
