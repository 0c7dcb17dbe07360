"""The infrared sensor of the paper's evaluation."""

import math

from sitaf_runtime import Hardware

NO_DISTANCE = -1.0
"""The value that `get_infrared_data` returns if there is no distance."""


class InfraredSensor:
    """The range sensors `ir1`, `ir2` and so on of a robot."""

    def __init__(self, hardware: Hardware) -> None:
        self._hardware = hardware
        self._sensors = []
        self._size = 1

    def set_size(self, size: int) -> None:
        """Property `Size`: the number of sensors, at least 1."""
        if size < 1:
            raise ValueError(f"Size must be at least 1, not {size}")
        self._size = size

    def enable(self) -> None:
        """Open the sensors. Before this call, there is no distance."""
        self._sensors = [
            self._hardware.range_sensor(f"ir{i}") for i in range(1, self._size + 1)
        ]

    def disable(self) -> None:
        """Release the sensors."""
        self._sensors = []

    def is_enabled(self) -> bool:
        """Whether the sensors are open."""
        return bool(self._sensors)

    def get_infrared_data(self, index_of_sensor: int, num_of_sensor: int) -> float:
        """The distance that one sensor measures, in metres.

        `num_of_sensor`, the number of sensors that the caller uses, is 1 to `Size`; `index_of_sensor` is 1 to that number.
        Returns NO_DISTANCE if an argument is out of range or no object is within the range of the sensor.
        """
        if not 1 <= num_of_sensor <= len(self._sensors):
            return NO_DISTANCE
        if not 1 <= index_of_sensor <= num_of_sensor:
            return NO_DISTANCE
        distance = self._sensors[index_of_sensor - 1].range()
        return distance if math.isfinite(distance) else NO_DISTANCE
