#pragma once

#include <string>

#include "sitaf/suite/case_result.hpp"

namespace sitaf::suite {

/// Where the results go, one line a case. Each line is handed to the kernel in one write the moment its case ends, so that the end of the
/// process, however sudden, loses none of them. Through a descriptor of the agent's each line begins with its number and a token. A failure
/// to write is a std::system_error.
class ResultsFile {
 public:
  /// Begins a new file, or goes on behind what is in it; a last line that a killed process left unfinished is then ended first. Takes the
  /// descriptor where the path names one: `fd:3`.
  ResultsFile(const std::string& path, bool append);
  ~ResultsFile();
  ResultsFile(const ResultsFile&) = delete;
  ResultsFile& operator=(const ResultsFile&) = delete;

  /// Writes an empty line: all is set up, and the first case begins. From then on the time limit of a case holds.
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
