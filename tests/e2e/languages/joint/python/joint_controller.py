"""The controller of examples/joint-pid in Python."""

from sitaf_runtime import Hardware

_PERIOD = 0.01
_STRONGEST = 8


class JointController:
    """Executed once a period: reads the encoder, commands the motor."""

    kp = ki = kd = 0.0

    def __init__(self, hardware: Hardware) -> None:
        self._motor = hardware.joint_motor("motor")
        self._encoder = hardware.joint_encoder("encoder")
        self._target = self._sum = 0.0
        self._periods = 0

    def start(self) -> None:
        self._target = self._encoder.position()

    def set_target(self, angle: float) -> None:
        self._target = angle

    def get_time(self) -> float:
        return self._periods * _PERIOD

    def on_execute(self) -> None:
        self._periods += 1
        error = self._target - self._encoder.position()
        effort = self.kp * error + self.ki * (self._sum + error * _PERIOD) - self.kd * self._encoder.velocity()
        if abs(effort) <= _STRONGEST:
            self._sum += error * _PERIOD
        self._motor.set_effort(max(-_STRONGEST, min(_STRONGEST, effort)))
