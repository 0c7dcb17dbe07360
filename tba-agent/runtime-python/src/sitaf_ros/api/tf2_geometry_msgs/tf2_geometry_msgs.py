"""Transforms messages of geometry_msgs."""

from __future__ import annotations

from typing import Any

import numpy as np
from tf2_py import rigid_of
from tf2_ros.buffer_interface import ConvertRegistration, TransformRegistration

from sitaf_ros.current import message
from sitaf_ros.transform_tree import multiplied, rotated


def to_msg_msg(msg: Any) -> Any:
    return msg


def from_msg_msg(msg: Any) -> Any:
    return msg


def _point(point: Any, transform: Any) -> Any:
    new = type(point)()
    new.x, new.y, new.z = rigid_of(transform.transform).applied((point.x, point.y, point.z))
    return new


def _vector(vector: Any, transform: Any) -> Any:
    new = type(vector)()
    new.x, new.y, new.z = rotated(rigid_of(transform.transform).rotation, (vector.x, vector.y, vector.z))
    return new


def _with_header(stamped: Any, transform: Any) -> Any:
    new = type(stamped)()
    new.header = transform.header.copy_message()
    return new


def do_transform_point(point: Any, transform: Any) -> Any:
    new = _with_header(point, transform)
    new.point = _point(point.point, transform)
    return new


def do_transform_vector3(vector3: Any, transform: Any) -> Any:
    new = _with_header(vector3, transform)
    new.vector = _vector(vector3.vector, transform)
    return new


def do_transform_pose(pose: Any, transform: Any) -> Any:
    new = message("geometry_msgs/msg/Pose")()
    new.position = _point(pose.position, transform)
    q, r = pose.orientation, new.orientation
    r.x, r.y, r.z, r.w = multiplied(rigid_of(transform.transform).rotation, (q.x, q.y, q.z, q.w))
    return new


def do_transform_pose_stamped(pose: Any, transform: Any) -> Any:
    new = _with_header(pose, transform)
    new.pose = do_transform_pose(pose.pose, transform)
    return new


def do_transform_pose_with_covariance_stamped(pose: Any, transform: Any) -> Any:
    new = _with_header(pose, transform)
    new.pose.pose = do_transform_pose(pose.pose.pose, transform)
    rotation = rigid_of(transform.transform).rotation
    columns = [rotated(rotation, axis) for axis in ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))]
    whole = np.zeros((6, 6))
    whole[:3, :3] = whole[3:, 3:] = np.array(columns).T
    covariance = np.asarray(pose.pose.covariance).reshape(6, 6)
    new.pose.covariance = (whole @ covariance @ whole.T).reshape(-1)
    return new


def do_transform_polygon_stamped(polygon: Any, transform: Any) -> Any:
    new = _with_header(polygon, transform)
    new.polygon.points = [_point(point, transform) for point in polygon.polygon.points]
    return new


def do_transform_wrench(wrench: Any, transform: Any) -> Any:
    new = _with_header(wrench, transform)
    new.wrench.force = _vector(wrench.wrench.force, transform)
    new.wrench.torque = _vector(wrench.wrench.torque, transform)
    return new


def _register() -> None:
    for name, function in (
        ("PointStamped", do_transform_point),
        ("Vector3Stamped", do_transform_vector3),
        ("PoseStamped", do_transform_pose_stamped),
        ("PoseWithCovarianceStamped", do_transform_pose_with_covariance_stamped),
        ("PolygonStamped", do_transform_polygon_stamped),
        ("WrenchStamped", do_transform_wrench),
    ):
        kind = message(f"geometry_msgs/msg/{name}")
        TransformRegistration().add(kind, function)
        ConvertRegistration().add_to_msg(kind, to_msg_msg)
        ConvertRegistration().add_from_msg(kind, from_msg_msg)


_register()
