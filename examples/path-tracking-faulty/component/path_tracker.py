"""Follows a line on two driven wheels by pure pursuit."""

import math

from sitaf_runtime import Hardware

WHEEL_RADIUS = 0.06
TRACK = 0.32
LENGTH = 2.8
PERIOD_S = 0.02
# The point on the line that the base steers to is this far ahead, in seconds and at least in metres.
LOOK_AHEAD_S = 0.8
SHORTEST_M = 0.2


class PathTracker:
    """Estimates its position from the rotation of the wheels."""

    def __init__(self, hardware: Hardware) -> None:
        self._hardware = hardware
        self._base = hardware.differential_drive("base")

    def follow(self, offset: float, speed: float) -> None:
        """Drive 2.8 m ahead on a line `offset` metres to the left, at `speed` in m/s."""
        x = y = heading = 0.0
        left, right = self._base.left_position(), self._base.right_position()
        while x < LENGTH:
            self._base.drive(
                speed, speed * curvature(offset - y, heading, look_ahead(speed))
            )
            self._hardware.sleep(PERIOD_S)
            turned_left = self._base.left_position() - left
            turned_right = self._base.right_position() - right
            left, right = left + turned_left, right + turned_right
            heading += (turned_right - turned_left) * WHEEL_RADIUS / TRACK
            moved = (turned_left + turned_right) * WHEEL_RADIUS / 2
            x += moved * math.cos(heading)
            y += moved * math.sin(heading)
        self._base.drive(0, 0)


def look_ahead(speed: float) -> float:
    """Return the distance to the point to steer to, in metres, at a speed in m/s."""
    return max(SHORTEST_M, LOOK_AHEAD_S * speed * 3.6)


def curvature(aside: float, heading: float, distance: float) -> float:
    """Return the curvature in 1/m of the arc to the point of the line at this distance.

    `aside` is how far the line is to the left of the base, in metres; `heading` is the angle to the line.
    """
    ahead = math.sqrt(max(0.0, distance**2 - aside**2))
    lateral = aside * math.cos(heading) - ahead * math.sin(heading)
    return 2 * lateral / (ahead**2 + aside**2)
