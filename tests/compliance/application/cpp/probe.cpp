#include "probe.hpp"

#include "sitaf/interfaces/Refused.hpp"

sitaf::interfaces::Place robot::Probe::Locate(std::int32_t kind) {
  if (kind == 2) {
    throw sitaf::interfaces::Refused("kind 2");
  }
  sitaf::interfaces::Place place;
  place.x = sensor_.Read(0.5);
  place.y = 2;
  place.life = life_;
  return place;
}
