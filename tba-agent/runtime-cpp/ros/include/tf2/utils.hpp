#pragma once

#include "tf2_geometry_msgs/tf2_geometry_msgs.hpp"

namespace tf2 {

namespace impl {

inline Quaternion quaternion_of(const Quaternion & q) {return q;}
inline Quaternion quaternion_of(const geometry_msgs::msg::Quaternion & q) {return {q.x, q.y, q.z, q.w};}
inline Quaternion quaternion_of(const geometry_msgs::msg::QuaternionStamped & q) {return quaternion_of(q.quaternion);}
inline Quaternion quaternion_of(const geometry_msgs::msg::Pose & p) {return quaternion_of(p.orientation);}
inline Quaternion quaternion_of(const geometry_msgs::msg::PoseStamped & p) {return quaternion_of(p.pose);}

}  // namespace impl

template<class A>
void getEulerYPR(const A & a, double & yaw, double & pitch, double & roll)
{
  Matrix3x3(impl::quaternion_of(a)).getEulerYPR(yaw, pitch, roll);
}
template<class A>
double getYaw(const A & a)
{
  double yaw, pitch, roll;
  getEulerYPR(a, yaw, pitch, roll);
  return yaw;
}
template<class A>
A getTransformIdentity()
{
  return A(Transform::getIdentity());
}

}  // namespace tf2
