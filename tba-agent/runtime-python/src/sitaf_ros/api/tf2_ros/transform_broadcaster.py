"""Sends transforms."""

from __future__ import annotations

from typing import Any

from rclpy.qos import QoSProfile

from sitaf_ros.current import message


class TransformBroadcaster:
    def __init__(self, node: Any, qos: Any = None) -> None:
        self._type = message("tf2_msgs/msg/TFMessage")
        self.pub_tf = node.create_publisher(self._type, "/tf", qos or QoSProfile(depth=100))

    def sendTransform(self, transform: Any) -> None:
        transforms = list(transform) if hasattr(transform, "__iter__") else [transform]
        self.pub_tf.publish(self._type(transforms=transforms))
