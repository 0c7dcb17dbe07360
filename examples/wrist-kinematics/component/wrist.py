"""A spherical wrist: three joints whose axes meet in one point."""

import math

from sitaf_interfaces import Quaternion


class Wrist:
    """Turns a hand by yaw, pitch and roll, in this order from the arm to the hand."""

    def reach(self, target: Quaternion) -> Quaternion:
        """Return the orientation at the joint angles that are computed for `target`."""
        return forward(*inverse(target))

    def angle_between(self, first: Quaternion, second: Quaternion) -> float:
        """Return the angle between two orientations in radians, 0 to pi."""
        a = (first.x, first.y, first.z, first.w)
        b = (second.x, second.y, second.z, second.w)
        # A quaternion and its negative are the same orientation. The half-angle formula is exact for small angles.
        apart = min(math.dist(a, b), math.dist(a, [-c for c in b]))
        return 4 * math.asin(min(1.0, apart / 2))


def inverse(q: Quaternion) -> tuple[float, float, float]:
    """Return roll, pitch and yaw in radians."""
    horizontal = math.hypot(
        2 * (q.y * q.z + q.w * q.x), 1 - 2 * (q.x * q.x + q.y * q.y)
    )
    pitch = math.atan2(2 * (q.w * q.y - q.x * q.z), horizontal)
    if horizontal < 1e-12:
        # The axes of yaw and roll are parallel: one of them can have any angle.
        roll = math.atan2(2 * (q.w * q.x - q.y * q.z), 1 - 2 * (q.x * q.x + q.z * q.z))
        return roll, pitch, 0.0
    roll = math.atan2(2 * (q.y * q.z + q.w * q.x), 1 - 2 * (q.x * q.x + q.y * q.y))
    yaw = math.atan2(2 * (q.x * q.y + q.w * q.z), 1 - 2 * (q.y * q.y + q.z * q.z))
    return roll, pitch, yaw


def forward(roll: float, pitch: float, yaw: float) -> Quaternion:
    """Return the orientation of the hand."""
    cr, sr = math.cos(roll / 2), math.sin(roll / 2)
    cp, sp = math.cos(pitch / 2), math.sin(pitch / 2)
    cy, sy = math.cos(yaw / 2), math.sin(yaw / 2)
    return Quaternion(
        sr * cp * cy - cr * sp * sy,
        cr * sp * cy + sr * cp * sy,
        cr * cp * sy - sr * sp * cy,
        cr * cp * cy + sr * sp * sy,
    )
