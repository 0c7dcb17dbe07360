#pragma once

#include <string>

#include "sitaf/suite/case_result.hpp"

namespace sitaf::suite {

/// Where the results go, one line a case. Each line is one write when its case ends, so a killed process loses none of
/// them. Through a descriptor that the agent opened, each line begins with its number and a token. A failure
/// to write is a std::system_error.
class ResultsFile {
 public:
  /// Creates a file or appends to it; a last line that a killed process left unfinished is ended first. Takes the
  /// descriptor where the path names one: `fd:3`.
  ResultsFile(const std::string& path, bool append);
  ~ResultsFile();
  ResultsFile(const ResultsFile&) = delete;
  ResultsFile& operator=(const ResultsFile&) = delete;

  /// Writes an empty line: set-up is complete and the first case begins. From now on the time limit of a case applies.
  void ready();

  /// Writes the line of a case.
  void save(CaseResult& result);

 private:
  void write(const std::string& line);

  std::string path_;
  int file_;
  /// Empty where lines are not numbered.
  std::string token_;
  long number_ = 0;
  int unsynced_ = 0;
};

}  // namespace sitaf::suite
