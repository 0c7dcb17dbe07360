"""Stops a car in front of an obstacle."""

from sitaf_interfaces import Battery, NoContact, NotArmed, NotStopped
from sitaf_runtime import Hardware

STOP_M = 0.5
LOW = 0.2


class CollisionGuard:
    """Remembers an obstacle until it is reset."""

    def __init__(self, hardware: Hardware, battery: Battery) -> None:
        self._front = hardware.range_sensor("front")
        self._battery = battery
        self._armed = False
        self._stopped = False

    def arm(self) -> None:
        self._armed = True

    def disarm(self) -> None:
        self._armed = False

    def check(self) -> str:
        if not self._armed:
            raise NotArmed("arm the guard first")
        if self._front.range() < STOP_M:
            self._stopped = True
        # Fault: a battery without contact hides a stop that is remembered.
        if self._is_low():
            return "STOP" if self._front.range() < STOP_M else "LOW"
        return "STOP" if self._stopped else "CLEAR"

    def reset(self) -> None:
        if not self._stopped:
            raise NotStopped("nothing has stopped the car")
        self._stopped = False

    def _is_low(self) -> bool:
        try:
            return self._battery.level() < LOW
        except NoContact:
            return True
