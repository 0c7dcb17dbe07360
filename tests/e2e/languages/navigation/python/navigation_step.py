"""The step of examples/navigation-step in Python."""

import math

from sitaf_interfaces import Decision, NoEcho, RangeFinder, WheelController


class NavigationStep:
    """Looks ahead twice, believes the nearer reading, and drives by it."""

    safe_distance = 1.0

    def __init__(self, finder: RangeFinder, wheels: WheelController) -> None:
        self._finder = finder
        self._wheels = wheels

    def step(self, desired_speed: float) -> tuple[Decision, float]:
        ahead = min(self._look(), self._look())
        if ahead < self.safe_distance:
            self._wheels.stop()
            return Decision.HALT, 0.0
        near = ahead < 2 * self.safe_distance
        speed = min(desired_speed, 0.3) if near else desired_speed
        self._wheels.drive(speed)
        return Decision.SLOW_DOWN if near else Decision.GO, speed

    def _look(self) -> float:
        try:
            measured = self._finder.get_range()
        except NoEcho:
            return 0.0
        return math.inf if math.isnan(measured) else measured
