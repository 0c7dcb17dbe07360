"""Turns a joint to an angle."""

from sitaf_runtime import Hardware

GAIN = 4.0
CLOSE_ENOUGH = 0.005
PERIOD_S = 0.02
LONGEST_S = 5.0


class JointMover:
    """Commands velocities in proportion to the angle that is left."""

    def __init__(self, hardware: Hardware) -> None:
        self._hardware = hardware
        self._motor = hardware.joint_motor("motor")
        self._encoder = hardware.joint_encoder("encoder")

    def TurnTo(self, angle: float) -> float:
        end = self._hardware.time() + LONGEST_S
        while self._hardware.time() < end:
            left = angle - self._encoder.position()
            if abs(left) < CLOSE_ENOUGH:
                break
            self._motor.set_velocity(GAIN * left)
            self._hardware.sleep(PERIOD_S)
        self._motor.set_velocity(0.0)
        return self._encoder.position()
