#pragma once

#include <string>

#include "geometry_msgs/msg/point_stamped.hpp"
#include "geometry_msgs/msg/pose_stamped.hpp"
#include "geometry_msgs/msg/pose_with_covariance_stamped.hpp"
#include "geometry_msgs/msg/quaternion_stamped.hpp"
#include "geometry_msgs/msg/transform_stamped.hpp"
#include "geometry_msgs/msg/vector3_stamped.hpp"
#include "geometry_msgs/msg/wrench_stamped.hpp"
#include "sitaf_ros/type_support.hpp"
#include "tf2/convert.hpp"

namespace tf2 {

namespace gm = geometry_msgs::msg;

inline void fromMsg(const gm::Vector3 & in, Vector3 & out) {out = Vector3(in.x, in.y, in.z);}
inline void fromMsg(const gm::Point & in, Vector3 & out) {out = Vector3(in.x, in.y, in.z);}
inline void fromMsg(const gm::Quaternion & in, Quaternion & out) {out = Quaternion(in.x, in.y, in.z, in.w);}
inline void fromMsg(const gm::Transform & in, Transform & out)
{
  out = Transform(
    Quaternion(in.rotation.x, in.rotation.y, in.rotation.z, in.rotation.w),
    Vector3(in.translation.x, in.translation.y, in.translation.z));
}
inline void fromMsg(const gm::Pose & in, Transform & out)
{
  out = Transform(
    Quaternion(in.orientation.x, in.orientation.y, in.orientation.z, in.orientation.w),
    Vector3(in.position.x, in.position.y, in.position.z));
}
inline void fromMsg(const gm::TransformStamped & in, Stamped<Transform> & out)
{
  Transform value;
  fromMsg(in.transform, value);
  out = Stamped<Transform>(value, sitaf_time_point(in.header.stamp), in.header.frame_id);
}
inline void fromMsg(const gm::PoseStamped & in, Stamped<Transform> & out)
{
  Transform value;
  fromMsg(in.pose, value);
  out = Stamped<Transform>(value, sitaf_time_point(in.header.stamp), in.header.frame_id);
}
// What is already a message stays one.
template<class M>
std::enable_if_t<sitaf_ros::IsMessage<M>::value> fromMsg(const M & in, M & out)
{
  out = in;
}

inline gm::Vector3 toMsg(const Vector3 & in)
{
  gm::Vector3 out;
  out.x = in.x();
  out.y = in.y();
  out.z = in.z();
  return out;
}
inline gm::Point & toMsg(const Vector3 & in, gm::Point & out)
{
  out.x = in.x();
  out.y = in.y();
  out.z = in.z();
  return out;
}
inline gm::Quaternion toMsg(const Quaternion & in)
{
  gm::Quaternion out;
  out.x = in.x();
  out.y = in.y();
  out.z = in.z();
  out.w = in.w();
  return out;
}
inline gm::Transform toMsg(const Transform & in)
{
  gm::Transform out;
  out.translation = toMsg(in.getOrigin());
  out.rotation = toMsg(in.getRotation());
  return out;
}
inline gm::Pose & toMsg(const Transform & in, gm::Pose & out)
{
  toMsg(in.getOrigin(), out.position);
  out.orientation = toMsg(in.getRotation());
  return out;
}
inline gm::TransformStamped toMsg(const Stamped<Transform> & in)
{
  gm::TransformStamped out;
  const std::int64_t nanos = in.stamp_.time_since_epoch().count();
  out.header.stamp.sec = static_cast<std::int32_t>(nanos / 1'000'000'000);
  out.header.stamp.nanosec = static_cast<std::uint32_t>(nanos % 1'000'000'000);
  out.header.frame_id = in.frame_id_;
  out.transform = toMsg(static_cast<const Transform &>(in));
  return out;
}
template<class M>
std::enable_if_t<sitaf_ros::IsMessage<M>::value, M> toMsg(const M & in)
{
  return in;
}

inline gm::TransformStamped sitaf_same(const gm::TransformStamped & t) {return t;}

#define SITAF_DO_TRANSFORM(type, ...) \
  template<> \
  inline void doTransform(const type & in, type & out, const gm::TransformStamped & stamped) \
  { \
    Transform t; \
    fromMsg(stamped.transform, t); \
    type made = in; \
    __VA_ARGS__ \
    out = made; \
  }
SITAF_DO_TRANSFORM(gm::Point, toMsg(t * Vector3(in.x, in.y, in.z), made); )
SITAF_DO_TRANSFORM(gm::Vector3, made = toMsg(t.getBasis() * Vector3(in.x, in.y, in.z)); )
SITAF_DO_TRANSFORM(gm::Quaternion, made = toMsg(t.getRotation() * Quaternion(in.x, in.y, in.z, in.w)); )
SITAF_DO_TRANSFORM(gm::Pose, Transform pose; fromMsg(in, pose); toMsg(t * pose, made); )
SITAF_DO_TRANSFORM(gm::PointStamped, doTransform(in.point, made.point, stamped); made.header = stamped.header; )
SITAF_DO_TRANSFORM(gm::Vector3Stamped, doTransform(in.vector, made.vector, stamped); made.header = stamped.header; )
SITAF_DO_TRANSFORM(
  gm::QuaternionStamped, doTransform(in.quaternion, made.quaternion, stamped); made.header = stamped.header; )
SITAF_DO_TRANSFORM(gm::PoseStamped, doTransform(in.pose, made.pose, stamped); made.header = stamped.header; )
SITAF_DO_TRANSFORM(
  gm::PoseWithCovarianceStamped, doTransform(in.pose.pose, made.pose.pose, stamped); made.header = stamped.header;
  // The covariance turns with the frame: R C R^T for each block.
  for (int a = 0; a < 2; ++a) {
    for (int b = 0; b < 2; ++b) {
      Matrix3x3 block;
      for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
          block[i][j] = in.pose.covariance[(3 * a + i) * 6 + 3 * b + j];
        }
      }
      const Matrix3x3 turned = t.getBasis() * block * t.getBasis().transpose();
      for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
          made.pose.covariance[(3 * a + i) * 6 + 3 * b + j] = turned[i][j];
        }
      }
    }
  } )
SITAF_DO_TRANSFORM(
  gm::TransformStamped, Transform inner; fromMsg(in.transform, inner); made.transform = toMsg(t * inner);
  made.header = stamped.header; )
SITAF_DO_TRANSFORM(
  gm::Wrench, doTransform(in.force, made.force, stamped); doTransform(in.torque, made.torque, stamped); )
SITAF_DO_TRANSFORM(gm::WrenchStamped, doTransform(in.wrench, made.wrench, stamped); made.header = stamped.header; )
#undef SITAF_DO_TRANSFORM

}  // namespace tf2
