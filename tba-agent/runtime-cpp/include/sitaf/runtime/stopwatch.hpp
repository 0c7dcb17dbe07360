#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <thread>
#include <utility>

namespace sitaf::runtime {

/// Measures one call of the component with the monotonic clock, and separately the time that the call spends in virtual hardware and in
/// stubs. Only the thread that started the stopwatch is measured; other threads of the component are not part of the call.
class Stopwatch {
 public:
  using Moment = std::chrono::steady_clock::time_point;

  /// Starts a new measurement.
  void start() {
    if (beforeCall_) {
      beforeCall_();
    }
    hardware_ = {};
    stub_ = {};
    total_ = {};
    called_ = true;
    owner_ = std::this_thread::get_id();
    running_ = true;
    began_ = std::chrono::steady_clock::now();
  }

  /// Ends the measurement.
  void stop() {
    total_ = std::chrono::steady_clock::now() - began_;
    running_ = false;
  }

  /// Gives the calling thread a stopwatch of its own while it lives; one that is passed on may be this one.
  class Separate {
   public:
    explicit Separate(Stopwatch& own) : earlier_(ofThread_) { ofThread_ = &own; }
    ~Separate() { ofThread_ = earlier_; }
    Separate(const Separate&) = delete;
    Separate& operator=(const Separate&) = delete;

   private:
    Stopwatch* earlier_;
  };

  /// The stopwatch of the calling thread: this one, unless it has its own.
  Stopwatch& ofThisThread() { return ofThread_ == nullptr ? *this : *ofThread_; }

  /// Sets what runs before each measurement, outside of the measured time.
  void beforeCall(std::function<void()> action) { beforeCall_ = std::move(action); }

  /// Clears the measurement.
  void reset() {
    running_ = false;
    called_ = false;
  }

  /// Whether a call is being measured. Then an exception comes from the component.
  bool isRunning() const { return running_; }

  /// Whether a call was started since the last reset.
  bool wasStarted() const { return called_; }

  /// Counts its lifetime as spent in virtual hardware or in a stub; nested objects count once.
  class ExcludedTime {
   public:
    enum class Kind { hardware, stub };

    ExcludedTime(Stopwatch& watch, Kind kind) : watch_(watch.ofThisThread()), kind_(kind) {
      counts_ = watch_.running_ && watch_.owner_ == std::this_thread::get_id() && !watch_.excluded_;
      if (counts_) {
        watch_.excluded_ = true;
        entered_ = std::chrono::steady_clock::now();
      }
    }
    ~ExcludedTime() {
      if (counts_) {
        (kind_ == Kind::hardware ? watch_.hardware_ : watch_.stub_) += std::chrono::steady_clock::now() - entered_;
        watch_.excluded_ = false;
      }
    }
    ExcludedTime(const ExcludedTime&) = delete;
    ExcludedTime& operator=(const ExcludedTime&) = delete;

   private:
    Stopwatch& watch_;
    Kind kind_;
    bool counts_;
    Moment entered_;
  };

  /// Time of the call in microseconds, without virtual hardware and stubs.
  double componentMicros() const {
    const double own = micros(total_) - micros(hardware_) - micros(stub_);
    return own > 0 ? own : 0;
  }

  /// Time spent in virtual hardware, in microseconds.
  double hardwareMicros() const { return micros(hardware_); }

  /// Time spent in stubs, in microseconds.
  double stubMicros() const { return micros(stub_); }

 private:
  using Span = std::chrono::steady_clock::duration;

  static double micros(Span span) { return std::chrono::duration<double, std::micro>(span).count(); }

  std::function<void()> beforeCall_;
  // Without overhead where a thread has none; constant initialisation needs no guard.
  inline static thread_local Stopwatch* ofThread_ = nullptr;

  // Other threads of the component read it.
  std::atomic<std::thread::id> owner_{};
  std::atomic<bool> running_{false};
  std::atomic<bool> called_{false};
  bool excluded_ = false;
  Moment began_;
  Span total_{};
  Span hardware_{};
  Span stub_{};
};

}  // namespace sitaf::runtime
