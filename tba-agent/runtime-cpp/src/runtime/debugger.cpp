#include "runtime/debugger.hpp"

#include <sys/prctl.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <string>
#include <thread>

namespace sitaf::runtime {
namespace {

constexpr const char* variable = "SITAF_DEBUGGER";
constexpr std::chrono::milliseconds pause{10};

bool isTraced() {
  const std::string name = "TracerPid:";
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.compare(0, name.size(), name) == 0) {
      return std::atol(line.c_str() + name.size()) != 0;
    }
  }
  return false;
}

}  // namespace

void waitForDebugger() {
  const char* const named = std::getenv(variable);
  if (named == nullptr) {
    return;
  }
  const std::string folder = named;
  ::unsetenv(variable);
  // Debuggers of the same user need not be ancestors of this process.
  ::prctl(PR_SET_PTRACER, PR_SET_PTRACER_ANY, 0, 0, 0);
  std::ofstream(folder + "/waiting").flush();
  const std::string release = folder + "/continue";
  while (!isTraced() && ::access(release.c_str(), F_OK) != 0) {
    std::this_thread::sleep_for(pause);
  }
}

}  // namespace sitaf::runtime
