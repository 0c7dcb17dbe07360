#pragma once

#include <cstring>
#include <string>

#include "sensor_msgs/image_encodings.hpp"
#include "sensor_msgs/msg/image.hpp"

namespace sensor_msgs {

static inline bool fillImage(
  msg::Image & image, const std::string & encoding, std::uint32_t rows, std::uint32_t columns, std::uint32_t step,
  const void * data)
{
  image.encoding = encoding;
  image.height = rows;
  image.width = columns;
  image.step = step;
  image.data.resize(static_cast<std::size_t>(step) * rows);
  std::memcpy(image.data.data(), data, image.data.size());
  image.is_bigendian = 0;
  return true;
}

static inline void clearImage(msg::Image & image) {image.data.resize(0);}

}  // namespace sensor_msgs
