#include "kernel.hpp"

#include <cxxabi.h>
#include <sys/mman.h>
#include <ucontext.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <memory>
#include <stdexcept>
#include <system_error>
#include <vector>

// AddressSanitizer has to know the stack on which the program is; absent in a node without it.
// https://github.com/google/sanitizers/issues/189
extern "C" {
__attribute__((weak)) void __sanitizer_start_switch_fiber(void ** kept, const void * bottom, std::size_t size);
__attribute__((weak)) void __sanitizer_finish_switch_fiber(
  void * kept, const void ** bottom_left, std::size_t * size_left);
__attribute__((weak)) void __asan_unpoison_memory_region(const volatile void * begin, std::size_t size);
}

namespace sitaf_ros {

namespace {

constexpr std::size_t STACK_BYTES = 8u << 20;
constexpr std::size_t MOST_THREADS = 512;
constexpr int LOOKS_AT_ONE_INSTANT = 500;
constexpr int CALLBACKS_AT_ONE_INSTANT = 20'000;
constexpr int WAITS_AT_THE_END = 1'000;
constexpr Nanos MILLISECOND = 1'000'000;
constexpr std::size_t SHARED_SIZE = 512;

/// Memory that this process shares with the one that was forked from it; null if there is none.
char * shared_page()
{
  static char * const page = [] {
      void * mapped = mmap(nullptr, SHARED_SIZE, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
      return mapped == MAP_FAILED ? nullptr : static_cast<char *>(mapped);
    }();
  return page;
}

// The exceptions that a thread handles belong to it (Itanium C++ ABI, 2.2.2).
struct Exceptions
{
  void * caught;
  unsigned int uncaught;
};

}  // namespace

struct Fiber
{
  std::uint64_t number;
  std::string name;
  std::function<void()> run;
  ucontext_t context;
  void * stack = nullptr;
  void * fake_stack = nullptr;  // of AddressSanitizer
  Exceptions exceptions{nullptr, 0};
  bool waiting = false;
  bool timed_out = false;
  bool finished = false;
  const void * address = nullptr;
  std::optional<Nanos> deadline;
};

namespace kernel {

namespace {

Nanos time_ = 0;
bool ending_ = false;
std::vector<std::unique_ptr<Fiber>> all_;
std::deque<Fiber *> ready_;
Fiber * current_ = nullptr;
ucontext_t driver_;
Exceptions driver_exceptions_{nullptr, 0};
const void * driver_stack_ = nullptr;
std::size_t driver_stack_bytes_ = 0;
std::string failure_;
std::uint64_t started_ = 0;
Nanos looked_at_ = -1;
int looks_ = 0;
bool looked_too_often_ = false;
Nanos called_at_ = -1;
int calls_ = 0;
bool called_too_often_ = false;
int late_waits_ = 0;

Exceptions & exceptions() {return *reinterpret_cast<Exceptions *>(abi::__cxa_get_globals());}

void leave_stack(void ** kept, const void * next, std::size_t bytes)
{
  if (__sanitizer_start_switch_fiber != nullptr) {
    __sanitizer_start_switch_fiber(kept, next, bytes);
  }
}

void enter_stack(void * kept, const void ** left = nullptr, std::size_t * bytes_left = nullptr)
{
  if (__sanitizer_finish_switch_fiber != nullptr) {
    __sanitizer_finish_switch_fiber(kept, left, bytes_left);
  }
}

void to_driver()
{
  Fiber * me = current_;
  me->exceptions = exceptions();
  exceptions() = driver_exceptions_;
  current_ = nullptr;
  leave_stack(me->finished ? nullptr : &me->fake_stack, driver_stack_, driver_stack_bytes_);
  swapcontext(&me->context, &driver_);
  enter_stack(me->fake_stack);
}

void run(Fiber * fiber)
{
  driver_exceptions_ = exceptions();
  exceptions() = fiber->exceptions;
  current_ = fiber;
  void * kept = nullptr;
  leave_stack(&kept, fiber->stack, STACK_BYTES);
  swapcontext(&driver_, &fiber->context);
  enter_stack(kept);
}

// Never returns: leaves the thread where it is.
[[noreturn]] void abandon()
{
  current_->finished = true;
  wake(current_);
  to_driver();
  std::abort();
}

void body()
{
  enter_stack(nullptr, &driver_stack_, &driver_stack_bytes_);
  Fiber * me = current_;
  try {
    me->run();
  } catch (...) {
    failed(me->number == 1 ? "main" : me->name, current_exception_text());
  }
  abandon();
}

void make_ready(Fiber * fiber)
{
  fiber->waiting = false;
  fiber->address = nullptr;
  ready_.push_back(fiber);
}

}  // namespace

Nanos now() {return time_;}
bool ending() {return ending_;}
bool in_fiber() {return current_ != nullptr;}
std::uint64_t current_number() {return current_ == nullptr ? 0 : current_->number;}
const std::string & failure() {return failure_;}

void running(const std::string & what)
{
  if (char * page = shared_page()) {
    const std::size_t size = std::min(what.size(), SHARED_SIZE - 1);
    std::memcpy(page, what.data(), size);
    page[size] = 0;
  }
}

const char * running()
{
  const char * page = shared_page();
  return page == nullptr ? "" : page;
}

bool looked_too_often() {return looked_too_often_;}
bool called_back_too_often() {return called_too_often_;}
void set_now(Nanos time) {time_ = std::max(time_, time);}

std::uint64_t start(const std::string & name, std::function<void()> run)
{
  if (all_.size() >= MOST_THREADS) {
    throw std::system_error(std::make_error_code(std::errc::resource_unavailable_try_again), "too many threads");
  }
  auto fiber = std::make_unique<Fiber>();
  fiber->number = ++started_;
  fiber->name = name;
  fiber->run = std::move(run);
  fiber->stack = mmap(
    nullptr, STACK_BYTES, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE | MAP_STACK, -1, 0);
  if (fiber->stack == MAP_FAILED) {
    throw std::system_error(std::make_error_code(std::errc::not_enough_memory), "no memory for a thread");
  }
  if (__asan_unpoison_memory_region != nullptr) {
    // An earlier thread that was abandoned may have left its marks in the same place.
    __asan_unpoison_memory_region(fiber->stack, STACK_BYTES);
  }
  mprotect(fiber->stack, 4096, PROT_NONE);
  getcontext(&fiber->context);
  fiber->context.uc_stack.ss_sp = fiber->stack;
  fiber->context.uc_stack.ss_size = STACK_BYTES;
  fiber->context.uc_link = nullptr;
  makecontext(&fiber->context, body, 0);
  ready_.push_back(fiber.get());
  all_.push_back(std::move(fiber));
  return started_;
}

void join(std::uint64_t number)
{
  while (true) {
    const auto found = std::find_if(
      all_.begin(), all_.end(), [&](const auto & fiber) {return fiber->number == number;});
    if (found == all_.end() || (*found)->finished) {
      return;
    }
    wait(found->get(), std::nullopt);
  }
}

bool wait(const void * address, std::optional<Nanos> deadline, bool returns_at_end)
{
  Fiber * me = current_;
  if (me == nullptr) {
    return false;  // while the sources are loaded
  }
  if (ending_) {
    const bool others = !ready_.empty();
    if (++late_waits_ > WAITS_AT_THE_END || (!deadline && !returns_at_end && !others)) {
      abandon();
    }
    if (others) {
      ready_.push_back(me);
      to_driver();
    }
    // Without a deadline it was woken, as far as the caller knows, and looks again.
    return !deadline;
  }
  me->timed_out = false;
  if (deadline && *deadline <= time_) {
    // A wait of no time lets the others run first.
    me->timed_out = true;
    ready_.push_back(me);
  } else {
    me->waiting = true;
    me->address = address;
    me->deadline = deadline;
  }
  to_driver();
  return !me->timed_out;
}

void wake(const void * address, bool all)
{
  for (const auto & fiber : all_) {
    if (fiber->waiting && fiber->address == address && address != nullptr) {
      make_ready(fiber.get());
      if (!all) {
        return;
      }
    }
  }
}

void sleep_until(Nanos time)
{
  if (time <= time_ && !ending_) {
    wait(nullptr, time_);
    return;
  }
  while (time_ < time && in_fiber() && !ending_) {
    wait(nullptr, time);
  }
  if (ending_) {
    wait(nullptr, time_);
  }
}

Nanos look()
{
  if (current_ != nullptr && !ending_) {
    if (looked_at_ != time_) {
      looked_at_ = time_;
      looks_ = 0;
    }
    if (++looks_ > LOOKS_AT_ONE_INSTANT) {
      looked_too_often_ = true;
      looks_ = 0;
      wait(nullptr, time_ + MILLISECOND);
    }
  }
  return EPOCH + time_;
}

void count_callback()
{
  if (called_at_ != time_) {
    called_at_ = time_;
    calls_ = 0;
  }
  if (++calls_ > CALLBACKS_AT_ONE_INSTANT && !ending_) {
    calls_ = 0;
    called_too_often_ = true;
    wait(nullptr, time_ + MILLISECOND);
  }
}

void run_ready()
{
  while (!ready_.empty()) {
    Fiber * next = ready_.front();
    ready_.pop_front();
    run(next);
    if (next->finished) {
      munmap(next->stack, STACK_BYTES);
      all_.erase(
        std::find_if(all_.begin(), all_.end(), [&](const auto & fiber) {return fiber.get() == next;}));
    }
  }
}

Nanos next_deadline()
{
  Nanos first = -1;
  for (const auto & fiber : all_) {
    if (fiber->waiting && fiber->deadline && (first < 0 || *fiber->deadline < first)) {
      first = *fiber->deadline;
    }
  }
  return first;
}

void advance_to(Nanos time)
{
  set_now(time);
  std::vector<Fiber *> due;
  for (const auto & fiber : all_) {
    if (fiber->waiting && fiber->deadline && *fiber->deadline <= time_) {
      due.push_back(fiber.get());
    }
  }
  std::stable_sort(
    due.begin(), due.end(), [](const Fiber * a, const Fiber * b) {return *a->deadline < *b->deadline;});
  for (Fiber * fiber : due) {
    fiber->timed_out = true;
    make_ready(fiber);
  }
}

void end()
{
  ending_ = true;
  for (const auto & fiber : all_) {
    if (fiber->waiting) {
      fiber->timed_out = fiber->deadline.has_value();
      make_ready(fiber.get());
    }
  }
  run_ready();
}

void failed(const std::string & where, const std::string & what)
{
  if (failure_.empty() && !ending_) {
    failure_ = where + "\t" + what;
  }
}

std::string current_exception_text()
{
  std::string type = "an exception";
  if (const std::type_info * thrown = abi::__cxa_current_exception_type()) {
    int status = 0;
    char * readable = abi::__cxa_demangle(thrown->name(), nullptr, nullptr, &status);
    type = status == 0 ? readable : thrown->name();
    std::free(readable);
  }
  try {
    throw;
  } catch (const std::exception & e) {
    return type + ": " + e.what();
  } catch (const std::string & text) {
    return type + ": " + text;
  } catch (const char * text) {
    return type + ": " + text;
  } catch (...) {
    return type;
  }
}

}  // namespace kernel
}  // namespace sitaf_ros
