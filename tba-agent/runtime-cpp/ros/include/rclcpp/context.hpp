#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "rclcpp/duration.hpp"
#include "rclcpp/macros.hpp"

namespace rclcpp {

class InitOptions
{
public:
  bool shutdown_on_signal = true;
  InitOptions & auto_initialize_logging(bool) {return *this;}
  bool auto_initialize_logging() const {return true;}
  InitOptions & set_domain_id(std::size_t id) {domain_ = id; return *this;}
  std::size_t get_domain_id() const {return domain_;}
  InitOptions & use_default_domain_id() {return *this;}

private:
  std::size_t domain_ = 0;
};

enum class SignalHandlerOptions {All, SigInt, SigTerm, None};

using OnShutdownCallbackHandle = std::shared_ptr<std::function<void()>>;
using PreShutdownCallbackHandle = OnShutdownCallbackHandle;

class Context : public std::enable_shared_from_this<Context>
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Context)

  virtual ~Context() = default;
  virtual void init(int argc, const char * const * argv, const InitOptions & options = InitOptions());
  virtual bool is_valid() const;
  virtual bool shutdown(const std::string & reason);
  std::string shutdown_reason() const {return reason_;}
  const InitOptions & get_init_options() const {return options_;}
  std::size_t get_domain_id() const {return options_.get_domain_id();}
  virtual std::function<void()> on_shutdown(std::function<void()> callback);
  virtual OnShutdownCallbackHandle add_on_shutdown_callback(std::function<void()> callback);
  /// Called while the context is still valid.
  virtual PreShutdownCallbackHandle add_pre_shutdown_callback(std::function<void()> callback);
  virtual bool remove_on_shutdown_callback(const OnShutdownCallbackHandle & handle);
  virtual bool remove_pre_shutdown_callback(const PreShutdownCallbackHandle & handle);
  bool sleep_for(const std::chrono::nanoseconds & time);
  void interrupt_all_sleep_for();

  std::vector<std::string> sitaf_arguments;

private:
  bool valid_ = false;
  std::string reason_;
  InitOptions options_;
  std::vector<OnShutdownCallbackHandle> callbacks_;
  std::vector<PreShutdownCallbackHandle> pre_callbacks_;
};

namespace contexts {

class DefaultContext : public Context
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(DefaultContext)
};

DefaultContext::SharedPtr get_global_default_context();

}  // namespace contexts

void init(
  int argc, const char * const * argv, const InitOptions & options = InitOptions(),
  SignalHandlerOptions = SignalHandlerOptions::All);
std::vector<std::string> init_and_remove_ros_arguments(
  int argc, const char * const * argv, const InitOptions & options = InitOptions());
std::vector<std::string> remove_ros_arguments(int argc, const char * const * argv);
bool ok(Context::SharedPtr context = nullptr);
bool shutdown(
  Context::SharedPtr context = nullptr, const std::string & reason = "user called rclcpp::shutdown()");
void on_shutdown(std::function<void()> callback, Context::SharedPtr context = nullptr);
bool sleep_for(const std::chrono::nanoseconds & time, Context::SharedPtr context = nullptr);
inline bool install_signal_handlers(SignalHandlerOptions = SignalHandlerOptions::All) {return true;}
inline bool signal_handlers_installed() {return true;}
inline bool uninstall_signal_handlers() {return true;}

}  // namespace rclcpp
