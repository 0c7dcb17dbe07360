"""Angles within one turn."""

import math

TURN = 2 * math.pi


class AngleNormalisation:
    """Brings angles to [-pi, pi]."""

    def normalise(self, angle: float) -> float:
        """The angle in radians without its whole turns."""
        return angle - TURN * round(angle / TURN)
