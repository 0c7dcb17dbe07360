"""Sends transforms that do not change."""

from __future__ import annotations

from typing import Any

from rclpy.qos import DurabilityPolicy, QoSProfile

from sitaf_ros.current import message


class StaticTransformBroadcaster:
    def __init__(self, node: Any, qos: Any = None) -> None:
        self._type = message("tf2_msgs/msg/TFMessage")
        profile = qos or QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self.pub_tf = node.create_publisher(self._type, "/tf_static", profile)
        self._sent: dict[str, Any] = {}

    def sendTransform(self, transform: Any) -> None:
        for one in list(transform) if hasattr(transform, "__iter__") else [transform]:
            self._sent[one.child_frame_id] = one
        self.pub_tf.publish(self._type(transforms=list(self._sent.values())))
