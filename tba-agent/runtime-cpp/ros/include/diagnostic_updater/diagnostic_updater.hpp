#pragma once

#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <functional>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "diagnostic_msgs/msg/diagnostic_array.hpp"
#include "rclcpp/rclcpp.hpp"

namespace diagnostic_updater {

class DiagnosticStatusWrapper : public diagnostic_msgs::msg::DiagnosticStatus
{
public:
  void summary(unsigned char given, const std::string & text)
  {
    level = given;
    message = text;
  }
  void summary(const diagnostic_msgs::msg::DiagnosticStatus & other) {summary(other.level, other.message);}
  void summaryf(unsigned char given, const char * format, ...) __attribute__((format(printf, 3, 4)))
  {
    char text[1000];
    va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    summary(given, text);
  }
  void clearSummary() {summary(0, "");}
  void mergeSummary(unsigned char given, const std::string & text)
  {
    if ((given > OK && level > OK) || (given == OK && level == OK)) {
      message += (message.empty() ? "" : "; ") + text;
    } else if (given > level) {
      message = text;
    }
    level = std::max<unsigned char>(level, given);
  }
  void mergeSummary(const diagnostic_msgs::msg::DiagnosticStatus & other) {mergeSummary(other.level, other.message);}
  void mergeSummaryf(unsigned char given, const char * format, ...) __attribute__((format(printf, 3, 4)))
  {
    char text[1000];
    va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    mergeSummary(given, std::string(text));
  }
  template<class T>
  void add(const std::string & key, const T & value)
  {
    std::stringstream text;
    if constexpr (std::is_same_v<T, bool>) {
      text << (value ? "True" : "False");
    } else {
      text << value;
    }
    diagnostic_msgs::msg::KeyValue pair;
    pair.key = key;
    pair.value = text.str();
    values.push_back(pair);
  }
  void addf(const std::string & key, const char * format, ...) __attribute__((format(printf, 3, 4)))
  {
    char text[1000];
    va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    add(key, std::string(text));
  }
  void clear() {values.clear();}
};

using TaskFunction = std::function<void (DiagnosticStatusWrapper &)>;

class DiagnosticTask
{
public:
  explicit DiagnosticTask(const std::string & name)
  : name_(name) {}
  virtual ~DiagnosticTask() = default;
  const std::string & getName() {return name_;}
  virtual void run(DiagnosticStatusWrapper & status) = 0;

private:
  const std::string name_;
};

template<class T>
class GenericFunctionDiagnosticTask : public DiagnosticTask
{
public:
  GenericFunctionDiagnosticTask(const std::string & name, std::function<void(T &)> call)
  : DiagnosticTask(name), call_(std::move(call)) {}
  void run(DiagnosticStatusWrapper & status) override {call_(status);}

private:
  std::function<void(T &)> call_;
};
using FunctionDiagnosticTask = GenericFunctionDiagnosticTask<DiagnosticStatusWrapper>;

class CompositeDiagnosticTask : public DiagnosticTask
{
public:
  using DiagnosticTask::DiagnosticTask;
  void addTask(DiagnosticTask * task) {tasks_.push_back(task);}
  void run(DiagnosticStatusWrapper & status) override
  {
    DiagnosticStatusWrapper combined;
    for (auto * task : tasks_) {
      status.summary(0, "");
      task->run(status);
      combined.mergeSummary(status);
    }
    status.summary(combined);
  }

private:
  std::vector<DiagnosticTask *> tasks_;
};

class Updater
{
public:
  template<class N>
  explicit Updater(N && node, double period = 1.0, bool = true)
  : core_(rclcpp::detail::core(std::forward<N>(node)).get()), period_(rclcpp::Duration::from_seconds(period))
  {
    if (!core_->has_parameter("diagnostic_updater.period")) {
      core_->declare_parameter("diagnostic_updater.period", rclcpp::ParameterValue(period));
    }
    period_ = rclcpp::Duration::from_seconds(core_->get_parameter("diagnostic_updater.period").as_double());
    publisher_ = rclcpp::create_publisher<diagnostic_msgs::msg::DiagnosticArray>(
      core_->shared_from_this(), "/diagnostics", rclcpp::QoS(1));
    restart();
  }

  using Interface = rclcpp::node_interfaces::NodeCore::SharedPtr;
  Updater(
    Interface base, Interface, Interface, Interface, Interface, Interface, double period = 1.0, bool immediately = true)
  : Updater(base, period, immediately) {}

  void add(const std::string & name, TaskFunction call)
  {
    tasks_.emplace_back(name, std::move(call));
    publish_one(name, 0, "Node starting up");
  }
  void add(DiagnosticTask & task)
  {
    add(task.getName(), [&task](DiagnosticStatusWrapper & status) {task.run(status);});
  }
  template<class T, class M>
  void add(const std::string & name, T * object, M method)
  {
    add(name, [object, method](DiagnosticStatusWrapper & status) {std::invoke(method, object, status);});
  }
  bool removeByName(const std::string & name)
  {
    for (auto it = tasks_.begin(); it != tasks_.end(); ++it) {
      if (it->first == name) {
        tasks_.erase(it);
        return true;
      }
    }
    return false;
  }
  void setHardwareID(const std::string & id) {hardware_ = id;}
  void setHardwareIDf(const char * format, ...) __attribute__((format(printf, 2, 3)))
  {
    char text[1000];
    va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    hardware_ = text;
  }
  rclcpp::Duration getPeriod() const {return period_;}
  void setPeriod(rclcpp::Duration period)
  {
    period_ = period;
    restart();
  }
  void setPeriod(double period) {setPeriod(rclcpp::Duration::from_seconds(period));}
  void force_update() {update();}
  void broadcast(unsigned char level, const std::string & message)
  {
    for (const auto & [name, call] : tasks_) {
      (void)call;
      publish_one(name, level, message);
    }
  }
  bool verbose_ = false;

private:
  void restart()
  {
    timer_ = rclcpp::create_timer(core_->shared_from_this(), core_->get_clock(), period_, [this] {update();});
  }
  void update()
  {
    diagnostic_msgs::msg::DiagnosticArray array;
    for (const auto & [name, call] : tasks_) {
      DiagnosticStatusWrapper status;
      status.name = name;
      status.level = 2;
      status.message = "No message was set";
      status.hardware_id = hardware_;
      call(status);
      array.status.push_back(status);
    }
    send(array);
  }
  void publish_one(const std::string & name, unsigned char level, const std::string & text)
  {
    diagnostic_msgs::msg::DiagnosticArray array;
    array.status.emplace_back();
    array.status[0].name = name;
    array.status[0].level = level;
    array.status[0].message = text;
    array.status[0].hardware_id = hardware_;
    send(array);
  }
  void send(diagnostic_msgs::msg::DiagnosticArray & array)
  {
    for (auto & status : array.status) {
      status.name = std::string(core_->get_name()) + ": " + status.name;
    }
    array.header.stamp = core_->now();
    publisher_->publish(array);
  }

  rclcpp::node_interfaces::NodeCore * core_;
  rclcpp::Duration period_;
  std::string hardware_ = "none";
  std::vector<std::pair<std::string, TaskFunction>> tasks_;
  std::shared_ptr<rclcpp::Publisher<diagnostic_msgs::msg::DiagnosticArray>> publisher_;
  std::shared_ptr<rclcpp::TimerBase> timer_;
};

}  // namespace diagnostic_updater
