"""A mobile base that approaches a wall with a laser scanner that may fail."""

import math

from sitaf_runtime import Hardware

FASTEST = 0.4
GAIN = 1.5
CLOSE_ENOUGH = 0.01
PERIOD_S = 0.02
LONGEST_S = 20.0


class CautiousApproach:
    """Drives straight towards a wall and stops in front of it; waits while the scanner gives no readings."""

    def __init__(self, hardware: Hardware) -> None:
        self._hardware = hardware
        self._base = hardware.differential_drive("base")
        self._lidar = hardware.laser_scanner("lidar")
        self._bumper = hardware.contact_sensor("bumper")

    def approach(self, distance: float) -> bool:
        """Approach the wall up to a distance in metres. Returns whether that was possible."""
        end = self._hardware.time() + LONGEST_S
        while self._hardware.time() < end and not self._bumper.is_pressed():
            left = self._ahead() - distance
            if left < CLOSE_ENOUGH:
                self._base.drive(0.0, 0.0)
                return True
            if math.isnan(left):
                # Without readings the base must not move.
                self._base.drive(0.0, 0.0)
            else:
                self._base.drive(min(FASTEST, GAIN * left), 0.0)
            self._hardware.sleep(PERIOD_S)
        self._base.drive(0.0, 0.0)
        return False

    def _ahead(self) -> float:
        """The reading of the middle ray, in metres; NaN if the scanner has failed."""
        ranges = self._lidar.ranges()
        return ranges[len(ranges) // 2]
