#pragma once

#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "diagnostic_updater/diagnostic_updater.hpp"

namespace diagnostic_updater {

struct FrequencyStatusParam
{
  FrequencyStatusParam(double * least, double * most, double tolerance = 0.1, int window = 5)
  : min_freq_(least), max_freq_(most), tolerance_(tolerance), window_size_(window) {}
  double * min_freq_;
  double * max_freq_;
  double tolerance_;
  int window_size_;
};

class FrequencyStatus : public DiagnosticTask
{
public:
  explicit FrequencyStatus(
    const FrequencyStatusParam & params, std::string name = "FrequencyStatus",
    rclcpp::Clock::SharedPtr clock = std::make_shared<rclcpp::Clock>())
  : DiagnosticTask(name), params_(params), clock_(std::move(clock)) {clear();}
  void clear()
  {
    count_ = 0;
    windows_.assign(static_cast<std::size_t>(params_.window_size_), {clock_->now().seconds(), 0});
    at_ = 0;
  }
  void tick() {++count_;}
  void run(DiagnosticStatusWrapper & status) override
  {
    const double now = clock_->now().seconds();
    const int events = count_ - windows_[at_].second;
    const double window = now - windows_[at_].first;
    const double frequency = events / window;
    windows_[at_] = {now, count_};
    at_ = (at_ + 1) % windows_.size();
    if (events == 0) {
      status.summary(2, "No events recorded.");
    } else if (*params_.min_freq_ > 0 && frequency < *params_.min_freq_ * (1 - params_.tolerance_)) {
      status.summary(1, "Frequency too low.");
    } else if (std::isfinite(*params_.max_freq_) && frequency > *params_.max_freq_ * (1 + params_.tolerance_)) {
      status.summary(1, "Frequency too high.");
    } else {
      status.summary(0, "Desired frequency met");
    }
    status.addf("Events in window", "%d", events);
    status.addf("Events since startup", "%d", count_);
    status.addf("Duration of window (s)", "%f", window);
    status.addf("Actual frequency (Hz)", "%f", frequency);
  }

private:
  const FrequencyStatusParam params_;
  rclcpp::Clock::SharedPtr clock_;
  int count_ = 0;
  std::vector<std::pair<double, int>> windows_;
  std::size_t at_ = 0;
};

struct TimeStampStatusParam
{
  explicit TimeStampStatusParam(double least = -1, double most = 5)
  : max_acceptable_(most), min_acceptable_(least) {}
  double max_acceptable_, min_acceptable_;
};

static const TimeStampStatusParam DefaultTimeStampStatusParam;

/// Compares stamps with the time at which they come.
class TimeStampStatus : public DiagnosticTask
{
public:
  explicit TimeStampStatus(
    const TimeStampStatusParam & params = TimeStampStatusParam(), std::string name = "Timestamp Status",
    rclcpp::Clock::SharedPtr clock = std::make_shared<rclcpp::Clock>())
  : DiagnosticTask(name), params_(params), clock_(std::move(clock)) {}
  void tick(double stamp)
  {
    if (stamp == 0) {
      saw_zero_ = true;
      return;
    }
    const double delta = clock_->now().seconds() - stamp;
    largest_ = saw_any_ ? std::max(largest_, delta) : delta;
    smallest_ = saw_any_ ? std::min(smallest_, delta) : delta;
    saw_any_ = true;
  }
  void tick(const rclcpp::Time & time) {tick(time.seconds());}
  void run(DiagnosticStatusWrapper & status) override
  {
    status.summary(0, "Timestamps are reasonable.");
    if (!saw_any_) {
      status.summary(1, "No data since last update.");
    } else {
      if (smallest_ < params_.min_acceptable_) {
        status.summary(2, "Timestamps too far in future seen.");
        ++early_;
      }
      if (largest_ > params_.max_acceptable_) {
        status.summary(2, "Timestamps too far in past seen.");
        ++late_;
      }
      if (saw_zero_) {
        status.summary(2, "Zero timestamp seen.");
        ++zero_;
      }
    }
    status.addf("Earliest timestamp delay:", "%f", smallest_);
    status.addf("Latest timestamp delay:", "%f", largest_);
    status.addf("Earliest acceptable timestamp delay:", "%f", params_.min_acceptable_);
    status.addf("Latest acceptable timestamp delay:", "%f", params_.max_acceptable_);
    status.add("Late diagnostic update count:", late_);
    status.add("Early diagnostic update count:", early_);
    status.add("Zero seen diagnostic update count:", zero_);
    saw_any_ = saw_zero_ = false;
    smallest_ = largest_ = 0;
  }

private:
  TimeStampStatusParam params_;
  rclcpp::Clock::SharedPtr clock_;
  int early_ = 0, late_ = 0, zero_ = 0;
  bool saw_zero_ = false, saw_any_ = false;
  double largest_ = 0, smallest_ = 0;
};

/// As above, but a stamp that does not come is no problem.
class SlowTimeStampStatus : public TimeStampStatus
{
public:
  using TimeStampStatus::TimeStampStatus;
  void tick_seen(double stamp)
  {
    seen_ = true;
    TimeStampStatus::tick(stamp);
  }
  void tick(double stamp) {tick_seen(stamp);}
  void tick(const rclcpp::Time & time) {tick_seen(time.seconds());}
  void run(DiagnosticStatusWrapper & status) override
  {
    TimeStampStatus::run(status);
    if (!std::exchange(seen_, false)) {
      status.summary(0, "No data since last update.");
    }
  }

private:
  bool seen_ = false;
};

class Heartbeat : public DiagnosticTask
{
public:
  Heartbeat()
  : DiagnosticTask("Heartbeat") {}
  void run(DiagnosticStatusWrapper & status) override {status.summary(0, "Alive");}
};

}  // namespace diagnostic_updater
