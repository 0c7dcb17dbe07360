"""Motions from rest to rest with limited speed and acceleration."""

import math


class SpeedProfile:
    """Plans trapezoidal profiles of the speed."""

    def duration(self, distance: float, speed: float, acceleration: float) -> float:
        """The time for a distance in metres, in seconds."""
        ramps = speed * speed / acceleration
        if distance <= ramps:
            return 2 * math.sqrt(distance / acceleration)
        return distance / speed + speed / acceleration
