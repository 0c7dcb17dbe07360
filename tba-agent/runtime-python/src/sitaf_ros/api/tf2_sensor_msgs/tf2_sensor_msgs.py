"""Transforms point clouds."""

from __future__ import annotations

from typing import Any

import numpy as np
from sensor_msgs_py import point_cloud2
from tf2_py import rigid_of
from tf2_ros.buffer_interface import ConvertRegistration, TransformRegistration

from sitaf_ros.current import message
from sitaf_ros.transform_tree import rotated


def to_msg_msg(msg: Any) -> Any:
    return msg


def from_msg_msg(msg: Any) -> Any:
    return msg


def transform_points(point_cloud: Any, transform: Any) -> Any:
    """Points as rows of an array."""
    rigid = rigid_of(transform)
    columns = [rotated(rigid.rotation, axis) for axis in ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))]
    return np.asarray(point_cloud) @ np.array(columns) + np.array(rigid.applied((0.0, 0.0, 0.0)))


def do_transform_cloud(cloud: Any, transform: Any) -> Any:
    points = point_cloud2.read_points(cloud).copy()
    moved = transform_points(point_cloud2.read_points_numpy(cloud, ["x", "y", "z"]), transform.transform)
    for i, name in enumerate("xyz"):
        points[name] = moved[:, i]
    new = cloud.copy_message()
    new.header = transform.header.copy_message()
    new.is_bigendian = False
    new.data = points.tobytes()
    return new


_CLOUD = message("sensor_msgs/msg/PointCloud2")
TransformRegistration().add(_CLOUD, do_transform_cloud)
ConvertRegistration().add_to_msg(_CLOUD, to_msg_msg)
ConvertRegistration().add_from_msg(_CLOUD, from_msg_msg)
