// Simulated time, and the threads of a node, which run one at a time in a defined order.
#pragma once

#include <cstdint>
#include <exception>
#include <functional>
#include <optional>
#include <string>

namespace sitaf_ros {

using Nanos = std::int64_t;

/// What system clocks show at simulation time 0.
constexpr Nanos EPOCH = 1'700'000'000'000'000'000;
constexpr Nanos SECOND = 1'000'000'000;

struct Fiber;

namespace kernel {

/// Simulation time since the nodes were made.
Nanos now();
/// Counts a look at a clock: a loop that only looks takes simulated time. Returns the time of system clocks.
Nanos look();
/// Whether the case has ended; waits return at once.
bool ending();
bool in_fiber();
/// A number of the running thread; 0 for the test driver.
std::uint64_t current_number();

/// Starts a thread of the node; it runs when those before it wait.
std::uint64_t start(const std::string & name, std::function<void()> run);
/// Waits until a thread has ended.
void join(std::uint64_t number);

/// Waits for `wake` of the address, at most to the deadline; returns false at the deadline. A wait without
/// deadline that does not return at the end of the case ends its thread then.
bool wait(const void * address, std::optional<Nanos> deadline, bool returns_at_end = false);
void wake(const void * address, bool all = true);
void sleep_until(Nanos time);
/// Counts callbacks at one instant: endless ones take simulated time.
void count_callback();
/// Keeps what the node does now, which the process that waits for it can read after a crash.
void running(const std::string & what);

/// Keeps the first failure of the node.
void failed(const std::string & where, const std::string & what);
/// The text of the exception that is being handled.
std::string current_exception_text();

}  // namespace kernel
}  // namespace sitaf_ros
