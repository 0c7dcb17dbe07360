"""Turns between headings."""

import math

MAX_HEADING = 1000.0


class OutOfRange(Exception):
    """A heading beyond `MAX_HEADING`."""


class HeadingControl:
    """Finds the shortest turn."""

    def turn(self, from_heading: float, to_heading: float) -> float:
        """The turn in radians, in (-pi, pi]."""
        if not abs(from_heading) <= MAX_HEADING:
            raise OutOfRange(f"{from_heading} is beyond {MAX_HEADING}")
        turn = (to_heading - from_heading) % (2 * math.pi)
        return turn
