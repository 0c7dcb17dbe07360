#include "sitaf/hardware.hpp"

#include <grpcpp/grpcpp.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <condition_variable>
#include <csignal>
#include <cstdint>
#include <iostream>
#include <mutex>
#include <set>
#include <sstream>
#include <thread>

#include "sitaf/hardware/v1/hardware.grpc.pb.h"

namespace sitaf::hardware {
namespace {

namespace pb = sitaf::hardware::v1;
using grpc::Status;
using grpc::StatusCode;

constexpr std::uint32_t min_timeout_ms = 10;
constexpr std::uint32_t max_timeout_ms = 10'000;

struct Served {
  std::shared_ptr<Device> device;
  Description description;
  std::mutex lock;
  // Guarded by Provider::holding_.
  std::string hold;
  std::string last_stop;
  std::uint64_t stops = 0;
};

class Provider final : public pb::HardwareProvider::Service {
 public:
  Provider(std::map<std::string, std::shared_ptr<Device>> devices, std::string name) : name_(std::move(name)) {
    for (auto& [device_name, device] : devices) {
      auto& served = devices_[device_name];
      served = std::make_unique<Served>();
      served->description = device->describe();
      served->device = std::move(device);
    }
  }

  void stop_all(const std::string& reason) { stop(all(), reason); }

  Status Describe(grpc::ServerContext* /*context*/, const pb::DescribeRequest* /*request*/,
                  pb::DescribeResponse* response) override {
    response->set_provider(name_);
    for (const auto& [name, served] : devices_) {
      auto* device = response->add_devices();
      device->set_name(name);
      device->set_kind(served->description.kind);
      for (const auto& field : served->description.fields) {
        auto* number = device->add_fields();
        number->set_name(field.name);
        number->set_unit(field.unit);
      }
      for (const auto& command : served->description.commands) {
        auto* number = device->add_commands();
        number->set_name(command.name);
        number->set_unit(command.unit);
        if (std::isfinite(command.low)) number->set_min(command.low);
        if (std::isfinite(command.high)) number->set_max(command.high);
      }
      for (const auto& parameter : served->description.parameters) device->add_parameters(parameter);
    }
    return Status::OK;
  }

  Status Hold(grpc::ServerContext* context,
              grpc::ServerReaderWriter<pb::HoldResponse, pb::HoldRequest>* stream) override {
    pb::HoldRequest first;
    if (!stream->Read(&first)) return Status::OK;
    if (first.timeout_ms() < min_timeout_ms || first.timeout_ms() > max_timeout_ms) {
      return {StatusCode::INVALID_ARGUMENT, "timeout_ms: must be within 10 to 10000"};
    }
    const std::set<std::string> unique(first.devices().begin(), first.devices().end());
    const std::vector<std::string> names(unique.begin(), unique.end());
    if (names.empty()) return {StatusCode::INVALID_ARGUMENT, "devices: the first message must name devices"};
    if (auto status = find(names); !status.ok()) return status;
    std::string hold;
    {
      const std::lock_guard guard(holding_);
      for (const auto& name : names) {
        if (!devices_[name]->hold.empty()) {
          return {StatusCode::RESOURCE_EXHAUSTED, "devices: another client holds " + name};
        }
      }
      hold = std::to_string(++holds_) + "-" + std::to_string(::getpid());
      for (const auto& name : names) devices_[name]->hold = hold;
    }
    pb::HoldResponse answer;
    answer.set_hold(hold);
    stream->Write(answer);
    const std::string reason = follow(*context, *stream, answer, std::chrono::milliseconds(first.timeout_ms()));
    stop(names, reason);
    {
      const std::lock_guard guard(holding_);
      for (const auto& name : names) devices_[name]->hold.clear();
    }
    return reason == disconnected ? Status::OK : Status(StatusCode::DEADLINE_EXCEEDED, reason + "; stopped");
  }

  Status Read(grpc::ServerContext* /*context*/, const pb::ReadRequest* request, pb::ReadResponse* response) override {
    std::vector<std::string> names(request->devices().begin(), request->devices().end());
    if (names.empty()) names = held(request->hold());
    if (auto status = find(names); !status.ok()) return status;
    if (auto status = require_hold(request->hold(), names); !status.ok()) return status;
    for (const auto& name : names) {
      auto* reading = response->add_readings();
      reading->set_device(name);
      auto& served = *devices_[name];
      try {
        const std::lock_guard guard(served.lock);
        const Reading found = served.device->read();
        if (found.values.size() != served.description.fields.size()) {
          throw DeviceError("gave " + std::to_string(found.values.size()) + " numbers instead of " +
                            std::to_string(served.description.fields.size()));
        }
        for (const double value : found.values) reading->add_values(value);
        const auto age = std::chrono::steady_clock::now() - found.taken;
        reading->set_age_ns(std::max<std::int64_t>(0, std::chrono::nanoseconds(age).count()));
      } catch (const std::exception& error) {
        reading->clear_values();
        reading->set_fault(error.what());
      }
    }
    return Status::OK;
  }

  Status Command(grpc::ServerContext* /*context*/, const pb::CommandRequest* request,
                 pb::CommandResponse* /*response*/) override {
    std::vector<std::string> names;
    for (const auto& command : request->commands()) names.push_back(command.device());
    if (auto status = find(names); !status.ok()) return status;
    if (auto status = require_hold(request->hold(), names); !status.ok()) return status;
    for (const auto& command : request->commands()) {
      if (auto status = check(command); !status.ok()) return status;
    }
    for (const auto& command : request->commands()) {
      auto& served = *devices_[command.device()];
      try {
        const std::lock_guard guard(served.lock);
        // The hold may have ended, and the device been stopped, while this call waited.
        if (auto status = require_hold(request->hold(), {command.device()}); !status.ok()) return status;
        served.device->command({command.numbers().begin(), command.numbers().end()});
      } catch (const std::exception& error) {
        return {StatusCode::UNAVAILABLE, command.device() + ": " + error.what()};
      }
    }
    return Status::OK;
  }

  Status Set(grpc::ServerContext* /*context*/, const pb::SetRequest* request, pb::SetResponse* /*response*/) override {
    const auto names = held(request->hold());
    if (names.empty()) return {StatusCode::FAILED_PRECONDITION, "hold: is not valid"};
    std::map<std::string, std::map<std::string, double>> wanted;
    for (const auto& [parameter, value] : request->parameters()) {
      bool known = false;
      for (const auto& name : names) {
        const auto& settable = devices_[name]->description.parameters;
        if (std::find(settable.begin(), settable.end(), parameter) != settable.end()) {
          wanted[name][parameter] = value;
          known = true;
        }
      }
      if (!known) return {StatusCode::INVALID_ARGUMENT, "parameters: " + parameter + " cannot be set"};
      if (!std::isfinite(value)) {
        return {StatusCode::INVALID_ARGUMENT, "parameters: " + parameter + " is not a finite number"};
      }
    }
    for (const auto& [name, parameters] : wanted) {
      auto& served = *devices_[name];
      try {
        const std::lock_guard guard(served.lock);
        served.device->set(parameters);
      } catch (const std::out_of_range& error) {
        return {StatusCode::OUT_OF_RANGE, name + ": " + error.what()};
      } catch (const std::exception& error) {
        return {StatusCode::UNAVAILABLE, name + ": " + error.what()};
      }
    }
    return Status::OK;
  }

  Status CheckHealth(grpc::ServerContext* /*context*/, const pb::CheckHealthRequest* request,
                     pb::CheckHealthResponse* response) override {
    std::vector<std::string> names(request->devices().begin(), request->devices().end());
    if (names.empty()) names = all();
    if (auto status = find(names); !status.ok()) return status;
    for (const auto& name : names) {
      auto& served = *devices_[name];
      auto* health = response->add_devices();
      health->set_device(name);
      try {
        const std::lock_guard guard(served.lock);
        health->set_fault(served.device->fault());
      } catch (const std::exception& error) {
        health->set_fault(error.what());
      }
      const std::lock_guard guard(holding_);
      health->set_safe_stops(served.stops);
      health->set_last_stop(served.last_stop);
      health->set_held(!served.hold.empty());
    }
    return Status::OK;
  }

  Status StopSafely(grpc::ServerContext* /*context*/, const pb::StopSafelyRequest* request,
                    pb::StopSafelyResponse* /*response*/) override {
    std::vector<std::string> names(request->devices().begin(), request->devices().end());
    if (names.empty()) names = all();
    if (auto status = find(names); !status.ok()) return status;
    const auto faults = stop(names, request->reason().empty() ? "a client asked for it" : request->reason());
    return faults.empty() ? Status::OK : Status(StatusCode::UNAVAILABLE, faults);
  }

 private:
  static constexpr const char* disconnected = "the client disconnected";

  // Answers heartbeats; returns why the hold ended.
  static std::string follow(grpc::ServerContext& context,
                            grpc::ServerReaderWriter<pb::HoldResponse, pb::HoldRequest>& stream,
                            const pb::HoldResponse& answer, std::chrono::milliseconds limit) {
    std::mutex lock;
    std::condition_variable changed;
    bool ended = false;
    std::uint64_t beats = 0;
    // Reading a stream has no time limit.
    std::thread reader([&] {
      pb::HoldRequest beat;
      while (stream.Read(&beat)) {
        {
          const std::lock_guard guard(lock);
          ++beats;
        }
        changed.notify_one();
        stream.Write(answer);
      }
      {
        const std::lock_guard guard(lock);
        ended = true;
      }
      changed.notify_one();
    });
    std::string reason = disconnected;
    {
      std::unique_lock guard(lock);
      std::uint64_t seen = 0;
      while (!ended) {
        if (!changed.wait_for(guard, limit, [&] { return ended || beats > seen; })) {
          reason = "no heartbeat within " + std::to_string(limit.count()) + " ms";
          break;
        }
        seen = beats;
      }
    }
    if (reason != disconnected) context.TryCancel();
    reader.join();
    return reason;
  }

  [[nodiscard]] std::vector<std::string> all() const {
    std::vector<std::string> names;
    for (const auto& entry : devices_) names.push_back(entry.first);
    return names;
  }

  std::vector<std::string> held(const std::string& hold) {
    const std::lock_guard guard(holding_);
    std::vector<std::string> names;
    for (const auto& [name, served] : devices_) {
      if (!hold.empty() && served->hold == hold) names.push_back(name);
    }
    return names;
  }

  Status find(const std::vector<std::string>& names) const {
    for (const auto& name : names) {
      if (devices_.count(name) == 0) return {StatusCode::NOT_FOUND, "devices: no device '" + name + "'"};
    }
    return Status::OK;
  }

  Status require_hold(const std::string& hold, const std::vector<std::string>& names) {
    const std::lock_guard guard(holding_);
    for (const auto& name : names) {
      if (hold.empty() || devices_[name]->hold != hold) {
        return {StatusCode::FAILED_PRECONDITION, "hold: does not hold " + name};
      }
    }
    return Status::OK;
  }

  Status check(const pb::DeviceCommand& command) {
    if (command.numbers().empty()) {
      return {StatusCode::INVALID_ARGUMENT, "commands: the command to " + command.device() + " is empty"};
    }
    const auto& known = devices_[command.device()]->description.commands;
    for (const auto& [name, value] : command.numbers()) {
      const auto number = std::find_if(known.begin(), known.end(), [&n = name](const Number& k) { return k.name == n; });
      const std::string shown = "commands: " + command.device() + "." + name;
      if (number == known.end()) return {StatusCode::INVALID_ARGUMENT, shown + " is not a number of the device"};
      if (!std::isfinite(value)) return {StatusCode::INVALID_ARGUMENT, shown + " is not a finite number"};
      if (value < number->low || value > number->high) {
        std::ostringstream message;
        message << shown << ": " << value << " is not within " << number->low << " to " << number->high;
        return {StatusCode::OUT_OF_RANGE, message.str()};
      }
    }
    return Status::OK;
  }

  // Stops devices; returns the faults of those that could not be stopped.
  std::string stop(const std::vector<std::string>& names, const std::string& reason) {
    std::string faults;
    for (const auto& name : names) {
      auto& served = *devices_[name];
      {
        const std::lock_guard guard(holding_);
        served.last_stop = reason;
        ++served.stops;
      }
      try {
        const std::lock_guard guard(served.lock);
        served.device->stop();
      } catch (const std::exception& error) {
        faults += (faults.empty() ? "" : "; ") + name + ": " + error.what();
      }
    }
    return faults;
  }

  std::string name_;
  std::map<std::string, std::unique_ptr<Served>> devices_;
  std::mutex holding_;
  std::uint64_t holds_ = 0;
};

}  // namespace

struct Server::Implementation {
  Provider provider;
  std::unique_ptr<grpc::Server> server;
};

Server::Server(std::map<std::string, std::shared_ptr<Device>> devices, const std::string& address,
               const std::string& name)
    : implementation_(new Implementation{{std::move(devices), name}, nullptr}) {
  grpc::ServerBuilder builder;
  int bound = 0;
  builder.AddListeningPort(address, grpc::InsecureServerCredentials(), &bound);
  builder.RegisterService(&implementation_->provider);
  // A provider that was killed leaves its socket. Devices are for the owner of the socket.
  if (address.rfind("unix:", 0) == 0) ::unlink(address.c_str() + 5);
  const auto before = ::umask(077);
  implementation_->server = builder.BuildAndStart();
  ::umask(before);
  if (implementation_->server == nullptr || bound == 0) throw std::runtime_error("cannot listen on " + address);
}

Server::~Server() {
  if (implementation_->server == nullptr) return;
  implementation_->provider.stop_all("the provider ends");
  implementation_->server->Shutdown(std::chrono::system_clock::now() + std::chrono::milliseconds(500));
}

void serve(std::map<std::string, std::shared_ptr<Device>> devices, const std::string& address,
           const std::string& name) {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGTERM);
  sigaddset(&signals, SIGINT);
  // Before the threads of the server, which inherit it.
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  const Server server(std::move(devices), address, name);
  std::cout << "listening " << address << std::endl;
  int received = 0;
  sigwait(&signals, &received);
}

}  // namespace sitaf::hardware
