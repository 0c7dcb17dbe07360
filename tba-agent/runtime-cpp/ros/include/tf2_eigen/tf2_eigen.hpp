// Conversions between messages and Eigen, which the package must find: `find_package(Eigen3)` or `packages: [eigen3]`.
#pragma once

#include <Eigen/Geometry>

#include "tf2_geometry_msgs/tf2_geometry_msgs.hpp"

namespace tf2 {

inline Eigen::Isometry3d transformToEigen(const geometry_msgs::msg::Transform & t)
{
  return Eigen::Isometry3d(
    Eigen::Translation3d(t.translation.x, t.translation.y, t.translation.z) *
    Eigen::Quaterniond(t.rotation.w, t.rotation.x, t.rotation.y, t.rotation.z));
}
inline Eigen::Isometry3d transformToEigen(const geometry_msgs::msg::TransformStamped & t)
{
  return transformToEigen(t.transform);
}
template<int Mode>
geometry_msgs::msg::TransformStamped eigenToTransform(const Eigen::Transform<double, 3, Mode> & in)
{
  geometry_msgs::msg::TransformStamped out;
  const Eigen::Quaterniond q(in.linear());
  out.transform.translation.x = in.translation().x();
  out.transform.translation.y = in.translation().y();
  out.transform.translation.z = in.translation().z();
  out.transform.rotation.x = q.x();
  out.transform.rotation.y = q.y();
  out.transform.rotation.z = q.z();
  out.transform.rotation.w = q.w();
  return out;
}
inline void fromMsg(const geometry_msgs::msg::Point & in, Eigen::Vector3d & out) {out = {in.x, in.y, in.z};}
inline void fromMsg(const geometry_msgs::msg::Vector3 & in, Eigen::Vector3d & out) {out = {in.x, in.y, in.z};}
inline void fromMsg(const geometry_msgs::msg::Quaternion & in, Eigen::Quaterniond & out)
{
  out = Eigen::Quaterniond(in.w, in.x, in.y, in.z);
}
template<int Mode>
void fromMsg(const geometry_msgs::msg::Pose & in, Eigen::Transform<double, 3, Mode> & out)
{
  out = Eigen::Transform<double, 3, Mode>(
    Eigen::Translation3d(in.position.x, in.position.y, in.position.z) *
    Eigen::Quaterniond(in.orientation.w, in.orientation.x, in.orientation.y, in.orientation.z));
}
inline geometry_msgs::msg::Point toMsg(const Eigen::Vector3d & in)
{
  geometry_msgs::msg::Point out;
  out.x = in.x();
  out.y = in.y();
  out.z = in.z();
  return out;
}
inline geometry_msgs::msg::Vector3 & toMsg(const Eigen::Vector3d & in, geometry_msgs::msg::Vector3 & out)
{
  out.x = in.x();
  out.y = in.y();
  out.z = in.z();
  return out;
}
inline geometry_msgs::msg::Quaternion toMsg(const Eigen::Quaterniond & in)
{
  geometry_msgs::msg::Quaternion out;
  out.x = in.x();
  out.y = in.y();
  out.z = in.z();
  out.w = in.w();
  return out;
}
template<int Mode>
geometry_msgs::msg::Pose toMsg(const Eigen::Transform<double, 3, Mode> & in)
{
  geometry_msgs::msg::Pose out;
  out.position = toMsg(Eigen::Vector3d(in.translation()));
  out.orientation = toMsg(Eigen::Quaterniond(in.linear()));
  return out;
}
template<>
inline void doTransform(
  const Eigen::Vector3d & in, Eigen::Vector3d & out, const geometry_msgs::msg::TransformStamped & transform)
{
  out = transformToEigen(transform) * in;
}
template<>
inline void doTransform(
  const Eigen::Isometry3d & in, Eigen::Isometry3d & out, const geometry_msgs::msg::TransformStamped & transform)
{
  out = transformToEigen(transform) * in;
}

}  // namespace tf2
