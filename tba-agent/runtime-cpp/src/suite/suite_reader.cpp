#include "suite/suite_reader.hpp"

#include <expat.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <deque>
#include <exception>
#include <map>
#include <system_error>

namespace sitaf::suite {
namespace {

constexpr int chunkBytes = 1 << 16;
constexpr std::size_t maxLiteralBytes = 64U << 20U;

const char* attribute(const char** attributes, const char* name) {
  for (; *attributes != nullptr; attributes += 2) {
    if (std::strcmp(attributes[0], name) == 0) {
      return attributes[1];
    }
  }
  return nullptr;
}

}  // namespace

/// The parser delivers cases through callbacks; a queue holds those that were not requested yet.
class SuiteReader::Document {
 public:
  explicit Document(const std::string& path)
      : name_(path.substr(path.rfind('/') + 1)), file_(std::fopen(path.c_str(), "rb")), parser_(XML_ParserCreate(nullptr)) {
    if (file_ == nullptr) {
      const int problem = errno;
      XML_ParserFree(parser_);
      throw std::system_error(problem, std::generic_category(), path);
    }
    XML_SetUserData(parser_, this);
    XML_SetElementHandler(parser_, &Document::started, &Document::ended);
    XML_SetCharacterDataHandler(parser_, &Document::text);
    XML_SetStartDoctypeDeclHandler(parser_, &Document::doctype);
    while (!inCases_ && more()) {
    }
    if (failure_ && !inCases_) {
      std::fclose(file_);
      XML_ParserFree(parser_);
      std::rethrow_exception(failure_);
    }
  }

  ~Document() {
    std::fclose(file_);
    XML_ParserFree(parser_);
  }

  Document(const Document&) = delete;
  Document& operator=(const Document&) = delete;

  const TestCase* peek(std::size_t ahead) {
    while (queue_.size() <= ahead && more()) {
    }
    return ahead < queue_.size() ? &queue_[ahead] : nullptr;
  }

  bool next() {
    if (begun_ && !queue_.empty()) {
      queue_.pop_front();
    }
    begun_ = true;
    if (peek(0) == nullptr && failure_) {
      std::rethrow_exception(failure_);
    }
    return !queue_.empty();
  }

 private:
  /// Reads the next chunk; false at the end of what can be read.
  bool more() {
    if (done_) {
      return false;
    }
    void* buffer = XML_GetBuffer(parser_, chunkBytes);
    const std::size_t bytes = buffer == nullptr ? 0 : std::fread(buffer, 1, chunkBytes, file_);
    const bool last = bytes < static_cast<std::size_t>(chunkBytes);
    if (buffer == nullptr || std::ferror(file_) != 0) {
      fail("cannot be read");
    } else if (XML_ParseBuffer(parser_, static_cast<int>(bytes), last ? 1 : 0) == XML_STATUS_ERROR && !failure_) {
      fail(XML_ErrorString(XML_GetErrorCode(parser_)));
    } else if (last && !inCases_ && !failure_) {
      fail("there is no <case_list>");
    }
    done_ = last || failure_;
    return !done_ || !queue_.empty();
  }

  void fail(const std::string& message) {
    if (!failure_) {
      failure_ = std::make_exception_ptr(CaseDataError(name_ + ":" + std::to_string(XML_GetCurrentLineNumber(parser_)) + ": " + message));
      XML_StopParser(parser_, XML_FALSE);
    }
  }

  static void doctype(void* self, const char* /*name*/, const char* /*system*/, const char* /*id*/, int /*subset*/) {
    static_cast<Document*>(self)->fail("a DTD or an entity is not allowed here");
  }

  static void text(void* self, const char* characters, int length) {
    auto* document = static_cast<Document*>(self);
    if (document->collecting_) {
      document->collected_.append(characters, static_cast<std::size_t>(length));
      if (document->collected_.size() > maxLiteralBytes) {
        document->fail("a value is too long");
      }
    }
  }

  static void started(void* self, const char* element, const char** attributes) {
    static_cast<Document*>(self)->start(element, attributes);
  }

  static void ended(void* self, const char* element) { static_cast<Document*>(self)->end(element); }

  void start(const std::string& element, const char** attributes) {
    if (++depth_ == 1 && element != "test_suite_data") {
      fail("the root is <" + element + ">, not <test_suite_data>");
    } else if (collecting_) {
      fail("<" + element + "> is unknown inside a value");
    } else if (inCase_) {
      // Expected values are skipped: only the agent uses them.
      if (element == "step" && !inStep_) {
        startStep(attributes);
        return;
      }
      collecting_ = element == "value" || element == "expected";
      if (!collecting_) {
        fail("<" + element + "> is unknown inside <" + (inStep_ ? "step" : "case") + ">");
      }
      collected_.clear();
    } else if (inCases_ && element == "case") {
      startCase(attributes);
    } else if (!inCases_ && element == "param") {
      const char* name = attribute(attributes, "name");
      if (name == nullptr) {
        fail("<param> has no attribute 'name'");
      } else if (std::find(declared_->begin(), declared_->end(), name) != declared_->end()) {
        fail("two parameters are named '" + std::string(name) + "'");
      } else {
        declared_->emplace_back(name);
      }
    } else if (!inCases_ && element == "step") {
      const char* name = attribute(attributes, "name");
      if (name == nullptr) {
        fail("<step> has no attribute 'name'");
      } else {
        declared_ = &namesOfSteps_[name];
      }
    } else if (element == "case_list") {
      inCases_ = true;
      shared_ = std::make_shared<const std::vector<std::string>>(names_);
      for (const auto& [name, names] : namesOfSteps_) {
        sharedOfSteps_[name] = std::make_shared<const std::vector<std::string>>(names);
      }
    }
  }

  void startStep(const char** attributes) {
    const char* name = attribute(attributes, "name");
    if (name == nullptr) {
      fail("<step> has no attribute 'name'");
      return;
    }
    inStep_ = true;
    stepName_ = name;
    const char* kind = attribute(attributes, "class");
    stepValid_ = kind == nullptr || std::strcmp(kind, "invalid") != 0;
    stepValues_.clear();
  }

  void endStep() {
    static const auto none = std::make_shared<const std::vector<std::string>>();
    inStep_ = false;
    const auto found = sharedOfSteps_.find(stepName_);
    const TestCase::Names names = found == sharedOfSteps_.end() ? none : found->second;
    const int number = static_cast<int>(steps_.size()) + 1;
    if (stepValues_.size() != names->size()) {
      fail("step " + std::to_string(number) + " (" + stepName_ + ") of case " + std::to_string(no_) + " has " +
           std::to_string(stepValues_.size()) + " values for " + std::to_string(names->size()) + " parameters");
      return;
    }
    steps_.emplace_back(no_, number, stepName_, stepValid_, names, std::move(stepValues_));
    stepValues_ = {};
  }

  void startCase(const char** attributes) {
    inCase_ = true;
    ++casesRead_;
    values_.clear();
    steps_.clear();
    values_.reserve(names_.size());
    const char* number = attribute(attributes, "no");
    const char* kind = attribute(attributes, "class");
    valid_ = kind == nullptr || std::strcmp(kind, "invalid") != 0;
    no_ = casesRead_;
    if (number != nullptr) {
      try {
        no_ = static_cast<int>(literals::whole(number, 1, std::numeric_limits<int>::max()));
      } catch (const CaseDataError& e) {
        fail(e.what());
      }
    }
  }

  void end(const std::string& element) {
    --depth_;
    if (collecting_) {
      collecting_ = false;
      if (element == "value" && inStep_) {
        stepValues_.push_back(collected_);
      } else if (element == "value") {
        if (values_.size() == names_.size()) {
          fail("case " + std::to_string(no_) + " has more values than the suite has parameters");
        }
        values_.push_back(collected_);
      }
    } else if (inStep_ && element == "step") {
      endStep();
    } else if (!inCases_ && element == "step") {
      declared_ = &names_;
    } else if (inCase_ && element == "case") {
      inCase_ = false;
      if (values_.size() < names_.size()) {
        fail("case " + std::to_string(no_) + " has " + std::to_string(values_.size()) + " values for " + std::to_string(names_.size()) +
             " parameters");
      } else {
        queue_.emplace_back(no_, valid_, shared_, std::move(values_), std::move(steps_));
        values_ = {};
        steps_ = {};
      }
    }
  }

  std::string name_;
  std::FILE* file_;
  XML_Parser parser_;
  std::exception_ptr failure_;
  std::deque<TestCase> queue_;
  std::vector<std::string> names_;
  TestCase::Names shared_;
  /// Names of the parameters of each call of a sequence.
  std::map<std::string, std::vector<std::string>> namesOfSteps_;
  std::map<std::string, TestCase::Names> sharedOfSteps_;
  /// Where the next <param> belongs.
  std::vector<std::string>* declared_ = &names_;
  bool begun_ = false;
  bool done_ = false;
  bool inCases_ = false;
  bool inCase_ = false;
  bool collecting_ = false;
  int depth_ = 0;
  int casesRead_ = 0;
  int no_ = 0;
  bool valid_ = true;
  std::string collected_;
  std::vector<std::string> values_;
  bool inStep_ = false;
  bool stepValid_ = true;
  std::string stepName_;
  std::vector<std::string> stepValues_;
  std::vector<TestStep> steps_;
};

SuiteReader::SuiteReader(const std::string& path) : document_(std::make_unique<Document>(path)) {}

SuiteReader::~SuiteReader() = default;

bool SuiteReader::next() { return document_->next(); }

const TestCase& SuiteReader::current() { return *document_->peek(0); }

const TestCase* SuiteReader::peek(std::size_t ahead) { return document_->peek(ahead); }

}  // namespace sitaf::suite
