#pragma once

#include "sensor_msgs/msg/imu.hpp"
#include "sensor_msgs/msg/magnetic_field.hpp"
#include "sensor_msgs/point_cloud2_iterator.hpp"
#include "tf2_geometry_msgs/tf2_geometry_msgs.hpp"

namespace tf2 {

template<>
inline void doTransform(
  const sensor_msgs::msg::PointCloud2 & in, sensor_msgs::msg::PointCloud2 & out,
  const geometry_msgs::msg::TransformStamped & stamped)
{
  Transform t;
  fromMsg(stamped.transform, t);
  sensor_msgs::msg::PointCloud2 made = in;
  made.header = stamped.header;
  sensor_msgs::PointCloud2Iterator<float> x(made, "x"), y(made, "y"), z(made, "z");
  for (std::size_t i = 0; i < static_cast<std::size_t>(made.width) * made.height; ++i, ++x, ++y, ++z) {
    const Vector3 point = t * Vector3(*x, *y, *z);
    *x = static_cast<float>(point.x());
    *y = static_cast<float>(point.y());
    *z = static_cast<float>(point.z());
  }
  out = made;
}

}  // namespace tf2
