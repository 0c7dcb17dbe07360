"""Adapts simple_pid.PID of release 0.1.0 to the interface PidController."""

import sys

from simple_pid import PID


class Clock:
    """Replaces the clock of the module: this release takes no time step."""

    def __init__(self) -> None:
        self.now = 0.0

    def time(self) -> float:
        """Seconds."""
        return self.now


class PidController:
    """A proportional and derivative controller with symmetric output limits."""

    def respond(
        self,
        kp: float,
        kd: float,
        setpoint: float,
        before: float,
        measured: float,
        dt: float,
        limit: float,
        automatic: bool,
    ) -> float:
        """Return the output after two measurements, `dt` seconds apart; 0 if the controller is off."""
        clock = Clock()
        sys.modules[PID.__module__].time = clock
        pid = PID(
            kp,
            0.0,
            kd,
            setpoint=setpoint,
            sample_time=None,
            output_limits=(-limit, limit),
            auto_mode=automatic,
        )
        clock.now += dt
        pid(before)
        clock.now += dt
        output = pid(measured)
        return 0.0 if output is None else output
