#include "suite/results_channel.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

namespace sitaf::suite {
namespace {

constexpr const char* prefix = "fd:";
constexpr std::size_t maxTokenLength = 128;
/// Higher than the numbers that programs usually use.
constexpr int lowestDescriptor = 64;
/// Large, so that a fast component rarely waits for the agent; the system may limit it.
constexpr int pipeBytes = 1 << 20;

// No types with constructors: these variables are set before C++ constructors run.
int heldDescriptor = -1;
char heldToken[maxTokenLength + 1];

/// Reads one line of standard input; the input after it belongs to the component.
bool readToken() {
  std::size_t length = 0;
  while (length <= maxTokenLength) {
    char c = 0;
    const ssize_t got = ::read(STDIN_FILENO, &c, 1);
    if (got < 0 && errno == EINTR) {
      continue;
    }
    if (got != 1) {
      return false;
    }
    if (c == '\n') {
      heldToken[length] = '\0';
      return length > 0;
    }
    if (length < maxTokenLength) {
      heldToken[length] = c;
    }
    ++length;
  }
  return false;
}

void hold(const char* results) {
  char* end = nullptr;
  const char* number = results + std::strlen(prefix);
  const long descriptor = std::strtol(number, &end, 10);
  if (end == number || *end != '\0' || descriptor < 3 || descriptor > 1023 || !readToken()) {
    return;
  }
  heldDescriptor = ::fcntl(static_cast<int>(descriptor), F_DUPFD_CLOEXEC, lowestDescriptor);
  ::close(static_cast<int>(descriptor));
#ifdef F_SETPIPE_SZ
  ::fcntl(heldDescriptor, F_SETPIPE_SZ, pipeBytes);
#endif
}

/// The runtime is a shared library of the program, so this runs before the initialisers of the component's code.
__attribute__((constructor(101))) void takeBeforeTheComponent(int argc, char** argv, char** /*environment*/) {
  for (int i = 1; i + 1 < argc; ++i) {
    if (std::strcmp(argv[i], "--results") == 0 && std::strncmp(argv[i + 1], prefix, std::strlen(prefix)) == 0) {
      hold(argv[i + 1]);
      return;
    }
  }
}

}  // namespace

bool ResultsChannel::isNamed(const std::string& results) { return results.compare(0, std::strlen(prefix), prefix) == 0; }

ResultsChannel ResultsChannel::take(const std::string& results) {
  if (heldDescriptor < 0) {
    hold(results.c_str());
  }
  if (heldDescriptor < 0) {
    throw std::runtime_error("--results " + results + ": there is no such open descriptor, or no line with its token on standard input");
  }
  ResultsChannel channel{heldDescriptor, heldToken};
  heldDescriptor = -1;
  std::memset(heldToken, 0, sizeof heldToken);
  return channel;
}

}  // namespace sitaf::suite
