// Serves real devices of a robot to tests of SITAF; see README.md. The protocol is proto/sitaf/hardware/v1.
#pragma once

#include <chrono>
#include <limits>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace sitaf::hardware {

// The device does not answer, or not as expected; the message goes to the test.
class DeviceError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// A number with its SI unit; the limits, both inclusive, are for commands.
struct Number {
  std::string name;
  std::string unit;
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
};

// Numbers in the order of Description::fields, and when they were measured.
struct Reading {
  std::vector<double> values;
  std::chrono::steady_clock::time_point taken = std::chrono::steady_clock::now();
};

struct Description {
  // The kind in the world's description, such as "range".
  std::string kind;
  // The numbers of a reading.
  std::vector<Number> fields;
  // The numbers that a command may contain; none for a sensor.
  std::vector<Number> commands;
  // The parameters of the world that set() can set.
  std::vector<std::string> parameters;
};

// One device. Calls come from several threads, but never two at a time for one device.
class Device {
 public:
  virtual ~Device() = default;

  // Does not change while the device is served.
  [[nodiscard]] virtual Description describe() const = 0;

  // The newest reading. Throws DeviceError.
  virtual Reading read() = 0;

  // Follows a command, whose numbers are within the limits. Throws DeviceError.
  virtual void command(const std::map<std::string, double>& /*numbers*/) { throw DeviceError("takes no commands"); }

  // Sets parameters of the environment, and returns when they are reached. Throws DeviceError, std::out_of_range.
  virtual void set(const std::map<std::string, double>& /*parameters*/) { throw DeviceError("sets no parameters"); }

  // Brings the device into a safe state. Throws DeviceError.
  virtual void stop() {}

  // Why the device does not work; empty if it does.
  virtual std::string fault() { return {}; }
};

// Serves devices while it exists; then they are stopped.
class Server {
 public:
  // Listens at unix:/PATH or 127.0.0.1:PORT. Throws std::runtime_error if the address cannot be used.
  Server(std::map<std::string, std::shared_ptr<Device>> devices, const std::string& address,
         const std::string& name = "sitaf hardware");
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

// Serves devices until SIGTERM or SIGINT.
void serve(std::map<std::string, std::shared_ptr<Device>> devices, const std::string& address,
           const std::string& name = "sitaf hardware");

}  // namespace sitaf::hardware
