#pragma once

#include <memory>
#include <string>

#include "sitaf/suite/upcoming.hpp"

namespace sitaf::suite {

/// Reads a `test_suite_data` document (paper, Fig. 9) case by case, so that memory does not grow with the suite. A document with a DTD is
/// rejected. An error in the document throws CaseDataError when the reader reaches it.
class SuiteReader : public Upcoming {
 public:
  /// Opens a suite; std::system_error when the file cannot be read.
  explicit SuiteReader(const std::string& path);
  ~SuiteReader() override;
  SuiteReader(const SuiteReader&) = delete;
  SuiteReader& operator=(const SuiteReader&) = delete;

  /// Goes to the next case; false after the last.
  bool next();

  /// The current case.
  const TestCase& current();

  const TestCase* peek(std::size_t ahead) override;

 private:
  class Document;
  std::unique_ptr<Document> document_;
};

}  // namespace sitaf::suite
