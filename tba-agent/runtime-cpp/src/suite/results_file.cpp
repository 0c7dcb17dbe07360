#include "suite/results_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "suite/results_channel.hpp"

namespace sitaf::suite {
namespace {

/// Maximum number of results that a power failure loses; a killed process loses none.
constexpr int linesToSync = 4096;

[[noreturn]] void fail(const std::string& path) { throw std::system_error(errno, std::generic_category(), path); }

}  // namespace

ResultsFile::ResultsFile(const std::string& path, bool append) : path_(path), file_(-1) {
  if (ResultsChannel::isNamed(path)) {
    ResultsChannel channel = ResultsChannel::take(path);
    file_ = channel.descriptor;
    token_ = std::move(channel.token);
    return;
  }
  file_ = ::open(path.c_str(), O_CREAT | O_RDWR | O_CLOEXEC | (append ? 0 : O_TRUNC), 0644);
  if (file_ < 0) {
    fail(path_);
  }
  const off_t end = ::lseek(file_, 0, SEEK_END);
  char last = '\n';
  if (end > 0 && ::pread(file_, &last, 1, end - 1) != 1) {
    fail(path_);
  }
  if (last != '\n') {
    write("\n");
  }
}

ResultsFile::~ResultsFile() {
  if (token_.empty()) {
    ::fdatasync(file_);
  }
  ::close(file_);
}

void ResultsFile::ready() { write("\n"); }

void ResultsFile::save(CaseResult& result) {
  write(result.line());
  if (token_.empty() && ++unsynced_ >= linesToSync) {
    unsynced_ = 0;
    ::fdatasync(file_);
  }
}

void ResultsFile::write(const std::string& line) {
  const std::string text = token_.empty() ? line : std::to_string(++number_) + " " + token_ + " " + line;
  const char* from = text.data();
  std::size_t left = text.size();
  while (left > 0) {
    const ssize_t written = ::write(file_, from, left);
    if (written < 0 && errno != EINTR) {
      fail(path_);
    }
    if (written > 0) {
      from += written;
      left -= static_cast<std::size_t>(written);
    }
  }
}

}  // namespace sitaf::suite
