#include "runtime/crash_reports.hpp"

#include <dlfcn.h>
#include <execinfo.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <exception>
#include <string>
#include <vector>

#include "runtime/thrown.hpp"

namespace sitaf::runtime {
namespace {

constexpr int maxFrames = 64;
constexpr int shownFrames = 16;
/// Size of the signal stack: after a stack overflow the handler cannot use the normal stack.
constexpr std::size_t alternateStackBytes = 1U << 16U;

char alternateStack[alternateStackBytes];
char reason[1024];
void (*flushCoverage)() = nullptr;

void write(const char* text) {
  const auto ignored = ::write(STDERR_FILENO, text, std::strlen(text));
  (void)ignored;
}

std::string withoutUnknownPlace(std::string line) {
  while (!line.empty() && (line.back() == '\n' || line.back() == ' ')) {
    line.pop_back();
  }
  const std::string unknown = " at ??:?";
  if (line.size() > unknown.size() && line.compare(line.size() - unknown.size(), unknown.size(), unknown) == 0) {
    line.resize(line.size() - unknown.size());
  }
  return line;
}

/// Function, file and line of an address and of the calls that are inlined there, innermost first, from addr2line, which is
/// part of the compiler; only the symbol when it is missing.
std::vector<std::string> placesOf(void* address) {
  Dl_info info{};
  if (::dladdr(address, &info) == 0 || info.dli_fname == nullptr) {
    return {};
  }
  // A return address is the one after the call.
  const auto offset = static_cast<char*>(address) - static_cast<char*>(info.dli_fbase) - 1;
  const std::string module = info.dli_fname;
  const bool ofSystem =
      module.compare(0, 5, "/usr/") == 0 || module.compare(0, 5, "/lib/") == 0 || module.find("libsitaf") != std::string::npos;
  if (ofSystem) {
    return {};
  }
  char command[4096];
  std::snprintf(command, sizeof command, "addr2line -Cfpie '%s' 0x%lx 2>/dev/null", module.c_str(), static_cast<unsigned long>(offset));
  std::vector<std::string> places;
  if (module.find('\'') == std::string::npos) {
    if (std::FILE* pipe = ::popen(command, "r")) {
      const std::string inlinedBy = " (inlined by) ";
      char buffer[2048];
      while (std::fgets(buffer, sizeof buffer, pipe) != nullptr) {
        std::string line = withoutUnknownPlace(buffer);
        if (line.compare(0, inlinedBy.size(), inlinedBy) == 0) {
          line.erase(0, inlinedBy.size());
        }
        if (line.compare(0, 2, "??") != 0) {
          places.push_back(line);
        }
      }
      ::pclose(pipe);
    }
  }
  if (places.empty() && info.dli_sname != nullptr) {
    places.push_back(demangled(info.dli_sname));
  }
  return places;
}

/// Whether a place is neither in the component nor in a library that came with it.
bool isForeign(const std::string& place) {
  return place.compare(0, 7, "sitaf::") == 0 || place.compare(0, 5, "main ") == 0 || place == "main" || place == "_start" ||
         place.find(" sitaf::runtime::") != std::string::npos || place.find(" at /usr/") != std::string::npos;
}

void report(void** frames, int count, const char* what) {
  std::string innermost;
  int shown = 0;
  for (int i = 0; i < count && shown < shownFrames; ++i) {
    for (const std::string& place : placesOf(frames[i])) {
      ++shown;
      write(("    at " + place + "\n").c_str());
      if (innermost.empty() && !isForeign(place)) {
        innermost = place;
      }
    }
  }
  write((std::string(what) + (innermost.empty() ? "" : " in " + innermost) + "\n").c_str());
}

/// Finds frames and names in a child process, because the heap of this one may be corrupt. The child has two seconds.
void onSignal(int number) {
  void* frames[maxFrames];
  const int count = ::backtrace(frames, maxFrames);
  const char* what = number == SIGQUIT ? "hangs" : reason[0] != '\0' ? reason : ::strsignal(number);
  const pid_t child = ::fork();
  if (child == 0) {
    for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGSYS, SIGQUIT}) {
      ::signal(signal, SIG_DFL);
    }
    ::alarm(2);
    report(frames, count, what);
    saveCoverage(true);
    ::_exit(0);
  }
  if (child < 0) {
    write(what);
    write("\n");
  }
  for (int i = 0; child > 0 && i < 250 && ::waitpid(child, nullptr, WNOHANG) == 0; ++i) {
    const timespec pause{0, 10000000};
    ::nanosleep(&pause, nullptr);
  }
  if (child > 0) {
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
  }
  ::signal(number, SIG_DFL);
  ::raise(number);
}

[[noreturn]] void onTerminate() {
  const std::exception_ptr thrown = std::current_exception();
  const std::string text =
      thrown ? "std::terminate: " + describe(thrown) : "std::terminate: a thread was still joinable, or an exception met another one";
  std::snprintf(reason, sizeof reason, "%s", text.c_str());
  for (char& c : reason) {
    c = c == '\n' || c == '\r' ? ' ' : c;
  }
  std::abort();
}

}  // namespace

void installCrashHandlers(void (*coverage)()) {
  flushCoverage = coverage;
  // The first call loads the library that backtrace needs; later it may be too late.
  void* frame[1];
  ::backtrace(frame, 1);
  stack_t stack{};
  stack.ss_sp = alternateStack;
  stack.ss_size = sizeof alternateStack;
  ::sigaltstack(&stack, nullptr);
  struct sigaction action {};
  action.sa_handler = onSignal;
  action.sa_flags = SA_ONSTACK | static_cast<int>(SA_RESETHAND);
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGSYS, SIGQUIT}) {
    ::sigaction(signal, &action, nullptr);
  }
  // A JVM blocks SIGQUIT in its threads, and child processes inherit that.
  sigset_t toUnblock;
  ::sigemptyset(&toUnblock);
  ::sigaddset(&toUnblock, SIGQUIT);
  ::pthread_sigmask(SIG_UNBLOCK, &toUnblock, nullptr);
  std::set_terminate(onTerminate);
}

void saveCoverage(bool end) {
  static auto last = std::chrono::steady_clock::now();
  const auto now = std::chrono::steady_clock::now();
  if (flushCoverage != nullptr && (end || now - last > std::chrono::milliseconds(500))) {
    last = now;
    flushCoverage();
  }
}

}  // namespace sitaf::runtime
