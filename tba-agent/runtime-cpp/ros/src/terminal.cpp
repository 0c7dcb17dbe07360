// The standard input of a node: a pseudo-terminal with the lines of the case. What the linker puts in the place of
// reads and polls in the node (ld --wrap) waits in simulated time.
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <stdarg.h>
#include <stdio.h>
#include <sys/ioctl.h>
#include <sys/select.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <deque>
#include <iostream>
#include <optional>
#include <streambuf>
#include <string>

#include "kernel.hpp"
#include "terminal.hpp"

using sitaf_ros::Nanos;
namespace kernel = sitaf_ros::kernel;

extern "C" {
ssize_t __real_read(int file, void * into, size_t size);
int __real_poll(pollfd * files, nfds_t count, int timeout);
int __real_select(int count, fd_set * reads, fd_set * writes, fd_set * errors, timeval * timeout);
int __real_ioctl(int file, unsigned long request, ...);
int __real_fileno(FILE * file);
ssize_t __wrap_read(int file, void * into, size_t size);
}

namespace {

constexpr Nanos MILLI = 1'000'000;
// How often other files, which are real, are looked at.
constexpr Nanos STEP = MILLI;

std::deque<std::string> lines;
// Whether the case has lines, and whether the node waited for one although it has none.
bool given = false;
bool lacking = false;
int master = -1;
FILE * input = nullptr;

bool readable()
{
  pollfd file{0, POLLIN, 0};
  return __real_poll(&file, 1, 0) > 0;
}

/// Puts the next line into the terminal if it is empty; whether something can be read.
bool feed()
{
  if (master < 0 || readable()) {
    return true;
  }
  if (lines.empty()) {
    return false;
  }
  const std::string line = lines.front() + "\n";
  lines.pop_front();
  if (write(master, line.data(), line.size()) < 0) {
    return false;
  }
  // What the terminal echoes is of no use, and it must not fill up.
  std::array<char, 4096> echo;
  while (__real_read(master, echo.data(), echo.size()) > 0) {
  }
  pollfd file{0, POLLIN, 0};
  return __real_poll(&file, 1, 1000) > 0;
}

/// Waits for input at most to a time; without one, to the end of the case.
bool wait_for_input(std::optional<Nanos> until)
{
  while (!feed()) {
    if (until && kernel::now() >= *until) {
      return false;
    }
    lacking = lacking || (!given && !until);
    kernel::wait(nullptr, until);
  }
  return true;
}

/// How long a read waits: the terminal's minimum of characters and time, as in termios(3).
std::optional<Nanos> patience()
{
  if ((fcntl(0, F_GETFL) & O_NONBLOCK) != 0) {
    return 0;
  }
  termios mode;
  if (tcgetattr(0, &mode) == 0 && (mode.c_lflag & ICANON) == 0 && mode.c_cc[VMIN] == 0) {
    return mode.c_cc[VTIME] * 100 * MILLI;
  }
  return std::nullopt;
}

class Cin : public std::streambuf
{
protected:
  int_type underflow() override
  {
    const ssize_t count = __wrap_read(0, text_.data(), text_.size());
    if (count <= 0) {
      return traits_type::eof();
    }
    setg(text_.data(), text_.data(), text_.data() + count);
    return traits_type::to_int_type(text_[0]);
  }
  std::streamsize showmanyc() override {return feed() ? 1 : 0;}

private:
  std::array<char, 4096> text_;
};

ssize_t read_input(void *, char * into, size_t size) {return __wrap_read(0, into, size);}

/// Looks with `look` until it finds something or the time is over.
template<class Look>
int until_found(std::optional<Nanos> until, bool has_input, Look look)
{
  for (;;) {
    if (has_input) {
      feed();
    }
    const int found = look();
    const Nanos now = kernel::now();
    if (found != 0 || (until && now >= *until)) {
      return found;
    }
    kernel::wait(nullptr, until ? std::min(*until, has_input ? *until : now + STEP) : now + STEP);
  }
}

}  // namespace

namespace sitaf_ros {

void add_input(const std::string & line)
{
  given = true;
  lines.push_back(line);
}

bool lacks_input() {return lacking;}

void begin_input()
{
  int slave = -1;
  if (master >= 0) {
    close(master);
  }
  if (openpty(&master, &slave, nullptr, nullptr, nullptr) != 0) {
    // A sandbox without terminals.
    int ends[2];
    if (pipe(ends) != 0) {
      return;
    }
    slave = ends[0];
    master = ends[1];
  }
  fcntl(master, F_SETFL, O_NONBLOCK);
  dup2(slave, 0);
  close(slave);
  static Cin cin;
  std::cin.rdbuf(&cin);
  std::cin.clear();
  if (input == nullptr) {
    input = fopencookie(nullptr, "r", {&read_input, nullptr, nullptr, nullptr});
    stdin = input;
  }
}

}  // namespace sitaf_ros

extern "C" {

ssize_t __wrap_read(int file, void * into, size_t size)
{
  if (file == 0 && master >= 0) {
    const auto wait = patience();
    if (!wait_for_input(wait ? std::optional<Nanos>(kernel::now() + *wait) : std::nullopt)) {
      if ((fcntl(0, F_GETFL) & O_NONBLOCK) == 0) {
        return 0;
      }
      errno = EAGAIN;
      return -1;
    }
  }
  return __real_read(file, into, size);
}

int __wrap_poll(pollfd * files, nfds_t count, int timeout)
{
  const bool has_input = std::any_of(files, files + count, [](const pollfd & one) {return one.fd == 0;});
  const auto until = timeout < 0 ? std::nullopt : std::optional<Nanos>(kernel::now() + timeout * MILLI);
  return until_found(until, has_input, [&] {return __real_poll(files, count, 0);});
}

int __wrap_select(int count, fd_set * reads, fd_set * writes, fd_set * errors, timeval * timeout)
{
  const bool has_input = reads != nullptr && count > 0 && FD_ISSET(0, reads);
  const auto until = timeout == nullptr ? std::nullopt :
    std::optional<Nanos>(kernel::now() + timeout->tv_sec * sitaf_ros::SECOND + timeout->tv_usec * 1000);
  fd_set none;
  FD_ZERO(&none);
  const fd_set wanted[3] = {reads ? *reads : none, writes ? *writes : none, errors ? *errors : none};
  return until_found(until, has_input, [&] {
      fd_set * sets[3] = {reads, writes, errors};
      for (int i = 0; i < 3; ++i) {
        if (sets[i] != nullptr) {
          *sets[i] = wanted[i];
        }
      }
      timeval now{0, 0};
      return __real_select(count, reads, writes, errors, &now);
    });
}

int __wrap_ioctl(int file, unsigned long request, ...)
{
  va_list given;
  va_start(given, request);
  void * argument = va_arg(given, void *);
  va_end(given);
  if (file == 0 && request == FIONREAD) {
    feed();
  }
  return __real_ioctl(file, request, argument);
}

int __wrap_fileno(FILE * file) {return file == input && file != nullptr ? 0 : __real_fileno(file);}

}  // extern "C"
