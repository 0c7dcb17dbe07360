#include "runtime/case_streams.hpp"

#include <sys/types.h>
#include <sys/uio.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <iostream>

#ifdef __GLIBCXX__
#include <ext/stdio_sync_filebuf.h>
#endif

namespace sitaf::runtime {

#if defined(__GLIBC__) && defined(__GLIBCXX__)
namespace {

/// Global because a process runs a single suite; volatile because components may print from any thread.
volatile int current = 0;

struct Stream {
  int descriptor;
  int announced;
};

Stream out{STDOUT_FILENO, 0};
Stream err{STDERR_FILENO, 0};

bool writeAll(int descriptor, const char* data, size_t size) {
  while (size > 0) {
    const ssize_t written = ::write(descriptor, data, size);
    if (written < 0 && errno == EINTR) {
      continue;
    }
    if (written < 0) {
      return false;
    }
    data += written;
    size -= static_cast<size_t>(written);
  }
  return true;
}

/// The C library calls this while it holds the lock of the stream.
ssize_t writeMarked(void* cookie, const char* data, size_t size) {
  auto& stream = *static_cast<Stream*>(cookie);
  const int no = current;
  if (size > 0 && stream.announced != no) {
    stream.announced = no;
    char mark[32];
    const int length = std::snprintf(mark, sizeof mark, "%ccase %d\n", '\x1e', no);
    writeAll(stream.descriptor, mark, static_cast<size_t>(length));
  }
  // The C library treats 0 as an error.
  return writeAll(stream.descriptor, data, size) ? static_cast<ssize_t>(size) : 0;
}

FILE* marked(Stream& stream) {
  cookie_io_functions_t functions{};
  functions.write = writeMarked;
  return fopencookie(&stream, "w", functions);
}

}  // namespace

void markCases() {
  FILE* const markedOut = marked(out);
  FILE* const markedErr = marked(err);
  if (markedOut == nullptr || markedErr == nullptr) {
    return;
  }
  // A component may call this, too. As only the first call has an effect, a later one cannot bind std::cout to the unmarked descriptor.
  std::ios::sync_with_stdio(false);
  std::setvbuf(markedErr, nullptr, _IONBF, 0);
  stdout = markedOut;
  stderr = markedErr;
  // Never destroyed, because destructors of static objects may print.
  static auto& outBuffer = *new __gnu_cxx::stdio_sync_filebuf<char>(stdout);
  static auto& errBuffer = *new __gnu_cxx::stdio_sync_filebuf<char>(stderr);
  std::cout.rdbuf(&outBuffer);
  std::cerr.rdbuf(&errBuffer);
  std::clog.rdbuf(&errBuffer);
}

void beginCase(int no) {
  std::fflush(stdout);
  current = no;
}
#else
void markCases() {}
void beginCase(int) {}
#endif

}  // namespace sitaf::runtime
