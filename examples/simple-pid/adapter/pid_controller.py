"""Adapts simple_pid.PID to the interface PidController."""

from simple_pid import PID


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
        pid = PID(
            kp,
            0.0,
            kd,
            setpoint=setpoint,
            sample_time=None,
            output_limits=(-limit, limit),
            auto_mode=automatic,
        )
        pid(before, dt=dt)
        output = pid(measured, dt=dt)
        return 0.0 if output is None else output
