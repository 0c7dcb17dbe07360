#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace sitaf {

/// An image, row by row from the top.
struct Image {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  /// `rgb8`: bytes red, green, blue; `32FC1`: metres, as little-endian floats.
  std::string encoding;
  std::vector<std::uint8_t> data;
};

/// A camera; shape of sensor_msgs/Image. Unlike other devices, each call reads it from the simulator.
class Camera {
 public:
  virtual ~Camera() = default;

  /// The device's name in the world description.
  virtual const std::string& name() const = 0;

  /// The image at the current step.
  virtual Image image() const = 0;
};

}  // namespace sitaf
