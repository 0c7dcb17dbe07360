"""Messages of the devices of a world, and commands from messages."""

from __future__ import annotations

import math
from typing import Any

# Angles of a field of view that sensor_msgs/Range asks for and devices do not have.
_NO_FIELD_OF_VIEW = 0.0
_UNKNOWN = math.nan
_BYTES_OF = {"rgb8": 3, "32FC1": 4}


class Odometry:
    """The pose of a differential drive from its measured speeds, from the origin of the case."""

    def __init__(self) -> None:
        self._at_ns = 0
        self._x = self._y = self._yaw = 0.0

    def move(self, time_ns: int, linear: float, angular: float) -> tuple[float, float, float]:
        """Move with the speeds since the last time; x and y in metres, yaw in radians."""
        seconds = (time_ns - self._at_ns) / 1e9
        middle = self._yaw + angular * seconds / 2
        self._at_ns = time_ns
        self._x += linear * seconds * math.cos(middle)
        self._y += linear * seconds * math.sin(middle)
        self._yaw += angular * seconds
        return self._x, self._y, self._yaw


def fields_of(topic: Any, reading: dict[str, Any], odometry: Odometry, time_ns: int) -> dict[str, Any]:
    """The fields of a device's message.

    `reading` holds `numbers` in the order of the device's fields, `setting` with the constants of the device, and
    `image` for a camera. Frames are those of `topic`.
    """
    name = topic.type.rpartition("/")[2]
    header = {"frame_id": topic.frame}
    numbers: list[float] = reading["numbers"]
    setting: dict[str, float] = reading.get("setting", {})
    if topic.kind == "laser_scan":
        return {
            "header": header,
            **{key: setting[key] for key in ("angle_min", "angle_max", "angle_increment", "range_min", "range_max")},
            "scan_time": 1.0 / topic.rate_hz,
            "ranges": numbers,
        }
    if topic.kind == "range":
        return {
            "header": header,
            "radiation_type": 1,
            "field_of_view": _NO_FIELD_OF_VIEW,
            "min_range": setting["min_range"],
            "max_range": setting["max_range"],
            "range": numbers[0],
        }
    if topic.kind == "imu":
        return {
            "header": header,
            "orientation": _quaternion(numbers[0:4]),
            "angular_velocity": _vector(numbers[4:7]),
            "linear_acceleration": _vector(numbers[7:10]),
        }
    if topic.kind == "pose":
        pose = {"position": _vector(numbers[0:3]), "orientation": _quaternion(numbers[3:7])}
        if name == "PoseStamped":
            return {"header": header, "pose": pose}
        named = {"header": header, "pose": {"pose": pose}}
        return {**named, "child_frame_id": topic.device} if name == "Odometry" else named
    if topic.kind == "joint_encoder":
        return {"header": header, "name": [topic.device], "position": [numbers[0]], "velocity": [numbers[1]]}
    if topic.kind == "differential_drive":
        linear, angular, left, right = numbers[:4]
        if name == "JointState":
            return {"header": header, "name": ["left", "right"], "position": [left, right]}
        x, y, yaw = odometry.move(time_ns, linear, angular)
        return {
            "header": header,
            "child_frame_id": topic.device,
            "pose": {"pose": {"position": {"x": x, "y": y}, "orientation": _turned(yaw)}},
            "twist": {"twist": {"linear": {"x": linear}, "angular": {"z": angular}}},
        }
    if topic.kind == "battery":
        return {
            "header": header,
            "voltage": numbers[0],
            "current": numbers[1],
            "charge": numbers[2],
            "percentage": numbers[3],
            "temperature": _UNKNOWN,
            "capacity": _UNKNOWN,
            "design_capacity": _UNKNOWN,
            "present": True,
        }
    image = reading["image"]
    return {
        "header": header,
        "height": image["height"],
        "width": image["width"],
        "encoding": image["encoding"],
        "step": image["width"] * _BYTES_OF.get(image["encoding"], 1),
        "data": bytes.fromhex(image["data"]),
    }


def transforms_of(readings: dict[str, dict[str, Any]], stamp: dict[str, int]) -> list[dict[str, Any]]:
    """The transforms of a world: from `world` to each pose device."""
    return [
        {
            "header": {"frame_id": "world", "stamp": stamp},
            "child_frame_id": device,
            "transform": {
                "translation": _vector(reading["numbers"][0:3]),
                "rotation": _quaternion(reading["numbers"][3:7]),
            },
        }
        for device, reading in sorted(readings.items())
        if reading["kind"] == "pose"
    ]


def command_of(fields: dict[str, Any]) -> list[float]:
    """Linear and angular speed of a Twist or TwistStamped."""
    twist = fields.get("twist", fields)
    return [float(twist["linear"]["x"]), float(twist["angular"]["z"])]


def _vector(numbers: list[float]) -> dict[str, float]:
    return dict(zip("xyz", numbers, strict=True))


def _quaternion(numbers: list[float]) -> dict[str, float]:
    return dict(zip("xyzw", numbers, strict=True))


def _turned(yaw: float) -> dict[str, float]:
    return {"x": 0.0, "y": 0.0, "z": math.sin(yaw / 2), "w": math.cos(yaw / 2)}
