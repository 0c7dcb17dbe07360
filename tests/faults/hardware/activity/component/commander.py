"""Commands a motor."""

import os
import signal

from sitaf_runtime import Hardware


class Commander:
    """Does what a test of the hardware guard needs."""

    def __init__(self, hardware: Hardware) -> None:
        self._hardware = hardware
        self._motor = hardware.joint_motor("motor")

    def Command(self, what: int) -> int:
        if what == 0:
            return sum(self._refused(number) for number in range(1000))
        self._motor.set_velocity(1.0)
        self._hardware.sleep(0.05)
        if what == 1:
            os.kill(os.getpid(), signal.SIGKILL)
        for _ in range(3000):
            self._motor.set_velocity(1.0)
            self._hardware.sleep(0.02)
        return 1000

    def _refused(self, number: int) -> int:
        """Try a command beyond the envelope, of which some are within the limits of the world."""
        beyond = (-1 if number % 2 else 1) * (1.5 + (number + 1) / 500)
        try:
            self._motor.set_velocity(beyond)
            self._hardware.sleep(0.005)
        except Exception:
            return 1
        return 0
