#pragma once

#include <cstdint>
#include <string>

#include "sitaf/interfaces/Place.hpp"
#include "sitaf/interfaces/Sensor.hpp"

namespace robot {

/// Records which hooks of its life cycle are called.
class Probe {
 public:
  explicit Probe(sitaf::interfaces::Sensor& sensor) : sensor_(sensor) {}

  void initialise() { life_ += "initialise"; }
  void initialize() { life_ += "initialize"; }
  void start() { life_ += " start"; }
  void onStart() { life_ += " onStart"; }

  sitaf::interfaces::Place Locate(std::int32_t kind);

 private:
  sitaf::interfaces::Sensor& sensor_;
  std::string life_;
};

}  // namespace robot
