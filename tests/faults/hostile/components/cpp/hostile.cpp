#include "hostile.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <net/if.h>
#include <netinet/in.h>
#include <signal.h>
#include <sys/ipc.h>
#include <sys/mman.h>
#include <sys/mount.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/shm.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/sysmacros.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <thread>
#include <vector>

namespace hostile {
namespace {

namespace fs = std::filesystem;
constexpr std::size_t mib = 1 << 20;
constexpr std::size_t much = std::size_t{3} << 30;
const char* const ports = "@PORTS@";

void breach(const std::string& text) { std::cout << "BREACH " << text << std::endl; }

void tooMuch(const std::string& what, std::size_t bytes) {
  if (bytes >= (std::size_t{2} << 30)) breach(what + ": " + std::to_string(bytes / mib) + " MiB");
}

std::string readAll(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream all;
  all << in.rdbuf();
  return all.str();
}

std::set<std::string> writableFolders() {
  char here[4096] = "";
  std::set<std::string> found{getcwd(here, sizeof here) ? here : "/tmp", "/tmp", "/dev/shm"};
  std::ifstream mounts("/proc/self/mountinfo");
  for (std::string line; std::getline(mounts, line);) {
    std::istringstream words(line);
    std::string word;
    for (int i = 0; i < 5; ++i) words >> word;
    found.insert(word);
  }
  for (auto it = found.begin(); it != found.end();) {
    struct stat what {};
    const bool usable = stat(it->c_str(), &what) == 0 && S_ISDIR(what.st_mode) && access(it->c_str(), W_OK) == 0;
    it = usable ? std::next(it) : found.erase(it);
  }
  return found;
}

std::size_t writeFiles(const std::string& folder, std::size_t most) {
  static const std::string block(mib, 'x');
  std::size_t total = 0;
  for (int i = 0; i < 20; ++i) {
    const int fd = open((folder + "/big" + std::to_string(i)).c_str(), O_CREAT | O_WRONLY, 0600);
    if (fd < 0) break;
    for (int j = 0; j < 200 && total < most; ++j) {
      if (write(fd, block.data(), mib) != static_cast<ssize_t>(mib)) break;
      total += mib;
    }
    close(fd);
  }
  return total;
}

bool inChild(const std::function<bool()>& work) {
  const pid_t pid = fork();
  if (pid == 0) _exit(work() ? 0 : 1);
  int status = 1;
  waitpid(pid, &status, 0);
  return status == 0;
}

std::vector<fs::path> parents() {
  std::vector<fs::path> all;
  for (fs::path at = fs::current_path(); at != at.parent_path(); at = at.parent_path()) all.push_back(at);
  return all;
}

void readsAgentKey() {
  for (const auto& folder : parents()) {
    for (const char* name : {"key", "agent.key"}) {
      if (!readAll(folder / name).empty()) breach("reads " + (folder / name).string());
    }
    if (access((folder / "spool").c_str(), R_OK) == 0) breach("sees " + (folder / "spool").string());
  }
}

void readsSecrets() {
  for (const char* name : {"/etc/shadow", "/root/.ssh", "/root/.m2/settings.xml", "/var/lib/sitaf", "/etc/sitaf"}) {
    if (access(name, R_OK) == 0) breach(std::string("reads ") + name);
  }
}

void readsEnvironment() {
  for (char** variable = environ; *variable; ++variable) {
    const std::string name = std::string(*variable).substr(0, std::string(*variable).find('='));
    for (const char* word : {"TOKEN", "SECRET", "ENROL", "PASSWORD"}) {
      if (name.find(word) != std::string::npos) breach("sees the variable " + name);
    }
  }
}

void readsProcesses() {
  for (const auto& entry : fs::directory_iterator("/proc")) {
    const std::string line = readAll(entry.path() / "cmdline");
    if (line.find("agent.jar") != std::string::npos || line.find("sitaf-server") != std::string::npos) {
      breach("sees process " + entry.path().string());
    }
  }
}

void otherBuilds() {
  const std::string own = fs::current_path();
  for (const auto& folder : parents()) {
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder.parent_path(), error)) {
      const std::string path = entry.path();
      if (own.rfind(path, 0) != 0 && path.find("attempt") != std::string::npos && access(path.c_str(), R_OK) == 0) {
        breach("sees " + path);
      }
    }
  }
}

void writesOutside() {
  std::vector<fs::path> places = parents();
  for (const char* name : {"/etc", "/usr", "/opt", "/var/tmp", "/root", "/home", "/"}) places.emplace_back(name);
  for (const auto& place : places) {
    const std::string canary = place / "sitaf-hostile-canary";
    const int fd = open(canary.c_str(), O_CREAT | O_WRONLY, 0600);
    if (fd >= 0) {
      close(fd);
      unlink(canary.c_str());
    }
  }
}

void deviceNodes() {
  for (const auto& folder : writableFolders()) {
    if (mknod((folder + "/disk").c_str(), S_IFBLK | 0666, makedev(254, 0)) == 0) breach("makes a device in " + folder);
  }
}

void setUserId() {
  fs::copy_file("/bin/sh", "s");
  chmod("s", 04777);
  if (chown("s", 0, 0) == 0) breach("gives a file to root");
  if (setuid(0) == 0 && chroot("/") == 0) breach("is root with rights");
}

void linksLeft() {
  for (const auto& folder : writableFolders()) {
    for (const char* name : {"1.glb", "2.glb", "results", "hostile.gcda", "build.log"}) {
      if (symlink("/etc/passwd", (folder + "/" + name).c_str()) != 0) continue;
    }
  }
}

void pipesLeft() {
  for (const auto& folder : writableFolders()) {
    for (const char* name : {"1.glb", "2.glb", "3.glb", "results", "hostile.gcda", "coverage"}) {
      const std::string path = folder + "/" + name;
      unlink(path.c_str());
      if (mkfifo(path.c_str(), 0666) != 0) continue;
    }
  }
}

void deepFolders() {
  const std::string name(100, 'd');
  for (const auto& folder : writableFolders()) {
    if (chdir(folder.c_str()) != 0) continue;
    for (int i = 0; i < 3000 && mkdir(name.c_str(), 0700) == 0 && chdir(name.c_str()) == 0; ++i) {
    }
  }
}

void closedFolders() {
  for (const auto& folder : writableFolders()) {
    mkdir((folder + "/closed").c_str(), 0700);
    close(open((folder + "/closed/file").c_str(), O_CREAT | O_WRONLY, 0000));
    chmod((folder + "/closed").c_str(), 0);
    chmod(folder.c_str(), 0);
  }
}

void manyFiles() {
  for (const auto& folder : writableFolders()) {
    int made = 0;
    for (; made < 300'000; ++made) {
      const int fd = open((folder + "/f" + std::to_string(made)).c_str(), O_CREAT | O_WRONLY, 0600);
      if (fd < 0) break;
      close(fd);
    }
    if (made >= 200'000) breach("makes " + std::to_string(made) + " files in " + folder);
  }
}

void muchDisk() {
  std::size_t total = 0;
  for (const auto& folder : writableFolders()) total += writeFiles(folder, much - total);
  tooMuch("disk", total);
}

void sparseFiles() {
  for (const auto& folder : writableFolders()) {
    const int fd = open((folder + "/1.glb").c_str(), O_CREAT | O_WRONLY, 0600);
    if (ftruncate(fd, off_t{1} << 40) == 0) close(fd);
  }
}

void oddNames() {
  for (const auto& folder : writableFolders()) {
    for (const std::string name : {"a\nb", "\xff\xfe", "-rf", "$(id)", "\x1b[2J", "case 1\n"}) {
      close(open((folder + "/" + name).c_str(), O_CREAT | O_WRONLY, 0600));
    }
  }
}

void networkLocal() {
  std::istringstream all(ports);
  for (int port; all >> port;) {
    const int s = socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_port = htons(static_cast<uint16_t>(port));
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    if (connect(s, reinterpret_cast<sockaddr*>(&to), sizeof to) == 0) breach("connects to port " + std::to_string(port));
    close(s);
  }
}

void networkInterfaces() {
  auto* names = if_nameindex();
  for (auto* at = names; at && at->if_index != 0; ++at) {
    if (std::string(at->if_name) != "lo") breach(std::string("sees the interface ") + at->if_name);
  }
}

void oddSockets() {
  const std::map<std::string, std::pair<int, int>> families{
      {"AF_ALG", {38, SOCK_SEQPACKET}}, {"AF_VSOCK", {40, SOCK_STREAM}}, {"AF_PACKET", {17, SOCK_RAW}}};
  for (const auto& [name, family] : families) {
    if (socket(family.first, family.second, 0) >= 0) breach("opens a socket of " + name);
  }
}

void tracesOthers() {
  for (const pid_t pid : {pid_t{1}, getppid()}) {
    if (ptrace(PTRACE_ATTACH, pid, nullptr, nullptr) == 0) breach("traces process " + std::to_string(pid));
  }
}

void killsAll() {
  for (const pid_t pid : {pid_t{1}, getppid(), pid_t{-1}}) kill(pid, SIGKILL);
}

void forkBomb() {
  std::vector<pid_t> children;
  for (int i = 0; i < 5000; ++i) {
    const pid_t pid = fork();
    if (pid < 0) break;
    if (pid == 0) {
      sleep(30);
      _exit(0);
    }
    children.push_back(pid);
  }
  if (children.size() > 2000) breach(std::to_string(children.size()) + " processes");
  for (const pid_t pid : children) kill(pid, SIGKILL);
}

void orphans() {
  if (fork() == 0) {
    setsid();
    if (fork() == 0) {
      for (int fd = 0; fd < 64; ++fd) close(fd);
      signal(SIGTERM, SIG_IGN);
      execl("/bin/sh", "sh", "-c", "sleep 3600; : sitaf-hostile-orphan", nullptr);
    }
    _exit(0);
  }
  usleep(300'000);
}

void orphansWithOutput() {
  if (fork() == 0) {
    setsid();
    sleep(3600);
    _exit(0);
  }
}

void hangs() {
  for (const int number : {SIGTERM, SIGINT, SIGHUP, SIGQUIT}) signal(number, SIG_IGN);
  sleep(3600);
}

void burnsThreads() {
  for (int i = 0; i < 400; ++i) {
    try {
      std::thread([] {
        const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
        while (std::chrono::steady_clock::now() < end) {
        }
      }).detach();
    } catch (const std::system_error&) {
      break;
    }
  }
  sleep(8);
}

void memory() {
  std::size_t total = 0;
  for (; total < much; total += mib) {
    void* block = std::malloc(mib);
    if (!block) break;
    std::memset(block, static_cast<int>(total / mib), mib);
    asm volatile("" : : "r"(block) : "memory");
  }
  tooMuch("memory", total);
}

void memoryOfChildren() {
  std::vector<pid_t> children;
  for (int i = 0; i < 16; ++i) {
    const pid_t pid = fork();
    if (pid == 0) {
      void* block = std::malloc(200 * mib);
      if (!block) _exit(1);
      std::memset(block, 1, 200 * mib);
      sleep(8);
      _exit(0);
    }
    children.push_back(pid);
  }
  std::size_t alive = 0;
  for (const pid_t pid : children) {
    int status = 1;
    if (pid > 0 && waitpid(pid, &status, 0) == pid && status == 0) ++alive;
  }
  tooMuch("memory of children", alive * 200 * mib);
}

void memoryShared() {
  std::size_t total = 0;
  for (; total < much; total += mib) {
    void* block = mmap(nullptr, mib, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (block == MAP_FAILED) break;
    std::memset(block, 1, mib);
  }
  tooMuch("shared memory", total);
}

void memoryMemfd() {
  static const std::string block(mib, 'x');
  std::size_t total = 0;
  for (int i = 0; i < 20; ++i) {
    const int fd = static_cast<int>(syscall(SYS_memfd_create, "x", 0));
    if (fd < 0) break;
    for (int j = 0; j < 200 && total < much && write(fd, block.data(), mib) == static_cast<ssize_t>(mib); ++j) total += mib;
  }
  tooMuch("memfd", total);
}

void memorySystemV() {
  std::size_t total = 0;
  while (total < much) {
    const int id = shmget(IPC_PRIVATE, 100 * mib, IPC_CREAT | 0600);
    if (id < 0) break;
    void* at = shmat(id, nullptr, 0);
    if (at == reinterpret_cast<void*>(-1)) break;
    std::memset(at, 1, 100 * mib);
    shmdt(at);
    total += 100 * mib;
  }
  tooMuch("System V memory", total);
}

void userNamespaces() {
  if (inChild([] { return syscall(SYS_unshare, 0x10000000) == 0; })) breach("makes a user namespace");
}

void ioUring() {
  char parameters[256] = {};
  if (syscall(SYS_io_uring_setup, 8, parameters) >= 0) breach("sets up io_uring");
}

void userfaultfd() {
  if (syscall(SYS_userfaultfd, 0) >= 0 || syscall(SYS_userfaultfd, 1) >= 0) breach("opens userfaultfd");
}

void kernelCalls() {
  const std::map<std::string, long> numbers{
      {"bpf", SYS_bpf},         {"perf_event_open", SYS_perf_event_open},     {"add_key", SYS_add_key},
      {"keyctl", SYS_keyctl},   {"mount", SYS_mount},                         {"setns", SYS_setns},
      {"swapon", SYS_swapon},   {"open_by_handle_at", SYS_open_by_handle_at}, {"init_module", SYS_init_module},
      {"quotactl", SYS_quotactl}, {"pivot_root", SYS_pivot_root}};
  for (const auto& [name, number] : numbers) {
    errno = 0;
    if (syscall(number, 0, 0, 0, 0, 0, 0) >= 0 || (errno != EPERM && errno != ENOSYS && errno != EACCES)) {
      breach(name + " is not refused: errno " + std::to_string(errno));
    }
  }
}

void mounts() {
  for (const auto& folder : writableFolders()) {
    if (mount("x", folder.c_str(), "tmpfs", 0, nullptr) == 0) breach("mounts over " + folder);
  }
}

void limitsRaised() {
  const rlimit all{RLIM_INFINITY, RLIM_INFINITY};
  for (const auto kind : {RLIMIT_NPROC, RLIMIT_DATA, RLIMIT_FSIZE}) {
    if (setrlimit(kind, &all) == 0) breach("raises its limits");
  }
}

/// Writes to whatever the results may go to.
void everywhere(const std::string& content) {
  for (int fd = 3; fd < 64; ++fd) {
    struct stat what {};
    if (fstat(fd, &what) == 0 && !S_ISSOCK(what.st_mode) && (fcntl(fd, F_GETFL) & O_ACCMODE) != O_RDONLY) {
      if (write(fd, content.data(), content.size()) < 0) continue;
    }
  }
  const std::string words = readAll("/proc/self/cmdline");
  const std::size_t at = words.find(std::string("--results") + '\0');
  if (at != std::string::npos) {
    std::ofstream(words.c_str() + at + 10, std::ios::app | std::ios::binary) << content;
  }
}

std::string forged(int no) {
  return "<case_record no=\"" + std::to_string(no) +
         "\" outcome=\"RETURNED\"><actual name=\"return\">1.0</actual></case_record>\n";
}

void forgeAll() {
  for (int no = 1; no < 60; ++no) everywhere(forged(no));
}

void flood(const std::string& line, std::size_t bytes) {
  std::string block;
  while (block.size() < mib) block += line;
  for (std::size_t done = 0; done < bytes; done += block.size()) everywhere(block);
}

void floodOutput() {
  std::string block;
  while (block.size() < mib) block += "line of output\n";
  for (int i = 0; i < 500; ++i) {
    if (write(1, block.data(), block.size()) < 0 || write(2, block.data(), block.size()) < 0) return;
  }
}

void floodMarks() {
  for (int i = 0; i < 200'000; ++i) std::cout << "\x1e" "case 1\nx\n\x1e" "case 2\ny\n";
}

struct Sleeper {
  ~Sleeper() { sleep(3600); }
};

void hangsAtExit() { static Sleeper sleeper; }

void overflowsStack(volatile char* before) {
  volatile char block[4096];
  block[0] = before ? *before : '0';
  overflowsStack(block);
  block[1] = block[0];
}

using Attack = std::function<void()>;

const std::map<std::string, Attack>& attacks() {
  static const std::map<std::string, Attack> all{
      {"reads-agent-key", readsAgentKey},
      {"reads-secrets", readsSecrets},
      {"reads-environment", readsEnvironment},
      {"reads-processes", readsProcesses},
      {"other-builds", otherBuilds},
      {"writes-outside", writesOutside},
      {"device-nodes", deviceNodes},
      {"set-user-id", setUserId},
      {"links-left", linksLeft},
      {"pipes-left", pipesLeft},
      {"deep-folders", deepFolders},
      {"closed-folders", closedFolders},
      {"many-files", manyFiles},
      {"much-disk", muchDisk},
      {"sparse-files", sparseFiles},
      {"odd-names", oddNames},
      {"network-local", networkLocal},
      {"network-interfaces", networkInterfaces},
      {"odd-sockets", oddSockets},
      {"traces-others", tracesOthers},
      {"kills-all", killsAll},
      {"fork-bomb", forkBomb},
      {"orphans", orphans},
      {"orphans-with-output", orphansWithOutput},
      {"hangs", hangs},
      {"stops", [] { raise(SIGSTOP); }},
      {"burns-threads", burnsThreads},
      {"exits", [] { _exit(0); }},
      {"exits-like-driver",
       [] {
         std::cerr << "sitaf: the simulator is gone" << std::endl;
         _exit(3);
       }},
      {"crashes", [] { raise(SIGSEGV); }},
      {"overflows-stack", [] { overflowsStack(nullptr); }},
      {"hangs-at-exit", hangsAtExit},
      {"memory", memory},
      {"memory-of-children", memoryOfChildren},
      {"memory-shared", memoryShared},
      {"memory-memfd", memoryMemfd},
      {"memory-dev-shm", [] { tooMuch("/dev/shm", writeFiles("/dev/shm", much)); }},
      {"memory-system-v", memorySystemV},
      {"user-namespaces", userNamespaces},
      {"io-uring", ioUring},
      {"userfaultfd", userfaultfd},
      {"kernel-calls", kernelCalls},
      {"mounts", mounts},
      {"limits-raised", limitsRaised},
      {"forges-and-exits",
       [] {
         forgeAll();
         _exit(0);
       }},
      {"repeats-results", [] { everywhere(forged(1) + forged(1)); }},
      {"floods-results", [] { flood("\n", 250 * mib); }},
      {"garbles-results", [] { flood("<not a result\n", 4 * mib); }},
      {"tears-results", [] { everywhere("<case_record no=\"1\" outc"); }},
      {"floods-output", floodOutput},
      {"floods-marks", floodMarks},
      {"long-message", [] { throw std::runtime_error(std::string(20 * mib, 'm')); }},
      {"odd-message", [] { throw std::runtime_error("]]><script>alert(1)</script>\x1b[2J\xff\xfe&amp;\r\n=cmd|' /C calc'!A0"); }},
      {"throws-number", [] { throw 42; }},
      {"closes-descriptors",
       [] {
         for (int fd = 3; fd < 4096; ++fd) close(fd);
       }},
  };
  return all;
}

}  // namespace

double HostileComponent::GetInfraredData(int, int) {
  if (kind_ == "forges-results") {
    forgeAll();
    return -999;
  }
  attacks().at(kind_)();
  return -1;
}

}  // namespace hostile
