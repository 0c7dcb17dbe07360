#pragma once

#include <cstdint>

namespace sitaf::interfaces {

/// The required interface RangeFinder, described in finder.idl.
class RangeFinder {
 public:
  virtual ~RangeFinder() = default;

  virtual double Range(std::int32_t index, double& quality) = 0;

  virtual void Switch(bool on) = 0;
};

}  // namespace sitaf::interfaces
