"""The infrared sensor of the paper's evaluation."""

import math

from sitaf_runtime import Hardware

NO_DISTANCE = -1.0
"""What `get_infrared_data` returns where there is no distance to return."""


class InfraredSensor:
    """The sensors of a robot; `ir1`, `ir2` and so on are their devices."""

    def __init__(self, hardware: Hardware) -> None:
        self._hardware = hardware
        self._sensors = []
        self._size = 1

    def set_size(self, size: int) -> None:
        """Property `Size`: how many sensors there are."""
        if size < 1:
            raise ValueError(f"Size must be at least 1, not {size}")
        self._size = size

    def enable(self) -> None:
        """Find the sensors. Until then nothing is measured."""
        self._sensors = [
            self._hardware.range_sensor(f"ir{i}") for i in range(1, self._size + 1)
        ]

    def disable(self) -> None:
        """Let the sensors go."""
        self._sensors = []

    def is_enabled(self) -> bool:
        """Whether the sensors measure."""
        return bool(self._sensors)

    def get_infrared_data(self, index_of_sensor: int, num_of_sensor: int) -> float:
        """The distance that one sensor measures, in metres.

        The index counts from 1 to the number of sensors that the caller uses, which is at most `Size`. NO_DISTANCE when
        an argument is out of range, or the sensor sees nothing within its range.
        """
        if not 1 <= num_of_sensor <= len(self._sensors):
            return NO_DISTANCE
        if not 1 <= index_of_sensor < num_of_sensor:
            return NO_DISTANCE
        distance = self._sensors[index_of_sensor - 1].range()
        return distance if math.isfinite(distance) else NO_DISTANCE
