"""Adapts simple_pid.PID, with a clock of its own, to the interface SwitchedController."""

import sys

from simple_pid import PID


class SwitchedController:
    """A proportional and integral controller with the setpoint 1."""

    def __init__(self) -> None:
        self._now = 0.0
        sys.modules["simple_pid.PID"]._current_time = lambda: self._now
        self._pid = PID(2.0, 1.0, 0.0, setpoint=1.0, sample_time=None)

    def wait(self) -> None:
        self._now += 1.0

    def on(self) -> None:
        self._pid.auto_mode = True

    def off(self) -> None:
        self._pid.auto_mode = False

    def update(self, measured: float) -> float:
        return self._pid(measured)
