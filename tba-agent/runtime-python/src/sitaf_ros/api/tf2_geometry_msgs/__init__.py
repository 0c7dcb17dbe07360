"""Transforms messages of geometry_msgs; importing it registers them with tf2_ros."""

from sitaf_ros.current import message

from .tf2_geometry_msgs import (
    do_transform_point,
    do_transform_polygon_stamped,
    do_transform_pose,
    do_transform_pose_stamped,
    do_transform_pose_with_covariance_stamped,
    do_transform_vector3,
    do_transform_wrench,
    from_msg_msg,
    to_msg_msg,
)

# Nodes import these from here, as the module of ROS has them from its own imports.
PointStamped = message("geometry_msgs/msg/PointStamped")
PoseStamped = message("geometry_msgs/msg/PoseStamped")
PoseWithCovarianceStamped = message("geometry_msgs/msg/PoseWithCovarianceStamped")
TransformStamped = message("geometry_msgs/msg/TransformStamped")
Vector3Stamped = message("geometry_msgs/msg/Vector3Stamped")

__all__ = [
    "PointStamped",
    "PoseStamped",
    "PoseWithCovarianceStamped",
    "TransformStamped",
    "Vector3Stamped",
    "do_transform_point",
    "do_transform_polygon_stamped",
    "do_transform_pose",
    "do_transform_pose_stamped",
    "do_transform_pose_with_covariance_stamped",
    "do_transform_vector3",
    "do_transform_wrench",
    "from_msg_msg",
    "to_msg_msg",
]
