"""Tells a driver how near the obstacle in front is."""

import math

from sitaf_runtime import Hardware

STOP_M = 0.3
NEAR_M = 1.0


class ParkingAid:
    """Reads one range finder."""

    def __init__(self, hardware: Hardware) -> None:
        self._front = hardware.range_sensor("front")

    def Zone(self) -> str:
        distance = self._front.range()
        if math.isnan(distance):
            return "UNKNOWN"
        if distance < STOP_M:
            return "STOP"
        return "NEAR" if distance < NEAR_M else "FREE"
