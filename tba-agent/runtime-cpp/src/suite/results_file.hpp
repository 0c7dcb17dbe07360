#pragma once

#include <string>

#include "sitaf/suite/case_result.hpp"

namespace sitaf::suite {

/// The output file for results, with one line per case. Each line is written in one call when its case ends, so a killed process
/// loses no results. When the output is a descriptor of the agent, each line starts with its number and a token. A failure to write
/// throws std::system_error.
class ResultsFile {
 public:
  /// Creates a file or appends to it; an incomplete last line from a killed process is terminated first. A path such as `fd:3` names an
  /// open descriptor.
  ResultsFile(const std::string& path, bool append);
  ~ResultsFile();
  ResultsFile(const ResultsFile&) = delete;
  ResultsFile& operator=(const ResultsFile&) = delete;

  /// Writes an empty line, which reports that set-up is complete. The agent then applies the time limit of a case.
  void ready();

  /// Writes the line of a case.
  void save(CaseResult& result);

 private:
  void write(const std::string& line);

  std::string path_;
  int file_;
  /// Empty when lines are not numbered.
  std::string token_;
  long number_ = 0;
  int unsynced_ = 0;
};

}  // namespace sitaf::suite
