"""A controller that copes with bad sensors, and five that each do not cope with one kind of them."""

import shutil

REFERENCE = '''"""A mobile base that approaches a wall with a laser scanner that may fail."""

import math

from sitaf_runtime import Hardware

FASTEST = 0.3
CREEP = 0.05
PERIOD_S = 0.02
LONGEST_S = 14.0
FROZEN_S = 0.2
MOST_JUMP = 0.15


class CautiousApproach:
    """Drives towards a wall, and only while the scanner gives plausible readings."""

    def __init__(self, hardware: Hardware) -> None:
        self._hardware = hardware
        self._base = hardware.differential_drive("base")
        self._lidar = hardware.laser_scanner("lidar")
        self._bumper = hardware.contact_sensor("bumper")
        self._last = math.nan
        self._changed_at = 0.0

    def approach(self, distance: float) -> bool:
        """Approach the wall up to a distance in metres. Returns whether that was possible."""
        end = self._hardware.time() + LONGEST_S
        self._changed_at = self._hardware.time()
        self._last = self._ahead()
        while self._hardware.time() < end and not self._bumper.is_pressed():
            ahead = self._ahead()
            if not self._is_plausible(ahead):
                self._base.drive(0.0, 0.0)
                self._hardware.sleep(PERIOD_S)
                continue
            left = ahead - distance
            if left < 0.01:
                self._base.drive(0.0, 0.0)
                return True
            self._base.drive(max(CREEP, min(FASTEST, left)), 0.0)
            self._hardware.sleep(PERIOD_S)
        self._base.drive(0.0, 0.0)
        return False

    def _is_plausible(self, ahead: float) -> bool:
        now = self._hardware.time()
        if math.isnan(ahead):
            return False
        if math.isinf(ahead):
            return False
        if ahead != self._last:
            self._changed_at = now
        self._last = ahead
        return now - self._changed_at < FROZEN_S

    def _ahead(self) -> float:
        """The reading of the middle ray, in metres."""
        ranges = self._lidar.ranges()
        return ranges[len(ranges) // 2]
'''

PLANTED = {
    "drives on without readings": (
        "        if math.isnan(ahead):\n            return False\n",
        "        if math.isnan(ahead):\n            return True\n",
    ),
    "takes out of range for a free way": (
        "        if math.isinf(ahead):\n            return False\n",
        "        if math.isinf(ahead):\n            return True\n",
    ),
    "does not notice a stuck reading": (
        "        return now - self._changed_at < FROZEN_S\n",
        "        return True\n",
    ),
    "cannot convert a missing reading": (
        "        if math.isnan(ahead):\n            return False\n",
        "        if round(ahead * 1000) < 0:\n            return False\n",
    ),
    "never drives again after a dropout": (
        "        if math.isnan(ahead):\n            return False\n",
        '        if math.isnan(ahead) or getattr(self, "_failed", False):\n'
        "            self._failed = True\n            return False\n",
    ),
}


def write(root, folder, planted=None):
    """Write the activity of the reference, or with a planted fault, into a folder."""
    shutil.copytree(root / "examples" / "sensor-dropout", folder)
    source = REFERENCE
    if planted is not None:
        before, after = PLANTED[planted]
        assert source.count(before) == 1, planted
        source = source.replace(before, after)
    (folder / "component" / "cautious_approach.py").write_text(source)
    return folder
