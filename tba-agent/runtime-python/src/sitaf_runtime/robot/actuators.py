"""What a component drives; commands hold until the next one, and act when time moves.

A command that a device does not take, or beyond its limits, is a ValueError.
"""

from abc import abstractmethod

from sitaf_runtime.robot.sensors import Device, JointEncoder


class JointMotor(JointEncoder):
    """A motor at a joint. The world decides which of the commands it takes."""

    __slots__ = ()

    @abstractmethod
    def effort(self) -> float:
        """What it exerts, in newton metres or newtons."""

    @abstractmethod
    def set_position(self, target: float) -> None:
        """Go to a position in radians or metres."""

    @abstractmethod
    def set_velocity(self, target: float) -> None:
        """Keep a velocity in radians or metres per second."""

    @abstractmethod
    def set_effort(self, target: float) -> None:
        """Exert an effort in newton metres or newtons."""


class DifferentialDrive(Device):
    """A base on two driven wheels."""

    __slots__ = ()

    @abstractmethod
    def linear(self) -> float:
        """Measured speed in metres per second, forward."""

    @abstractmethod
    def angular(self) -> float:
        """Measured turning in radians per second, counterclockwise."""

    @abstractmethod
    def left_position(self) -> float:
        """Radians that the left wheel has turned."""

    @abstractmethod
    def right_position(self) -> float:
        """Radians that the right wheel has turned."""

    @abstractmethod
    def drive(self, linear: float, angular: float) -> None:
        """Command a speed in m/s and a turning in rad/s."""


class Gripper(Device):
    """A gripper with two fingers."""

    __slots__ = ()

    @abstractmethod
    def width(self) -> float:
        """Measured distance between the fingers in metres."""

    @abstractmethod
    def effort(self) -> float:
        """What the fingers exert, in newtons; closing is negative."""

    @abstractmethod
    def move(self, width: float) -> None:
        """Go to a width in metres."""


class DigitalLine(Device):
    """A digital input or output."""

    __slots__ = ()

    @abstractmethod
    def is_high(self) -> bool:
        """Its level."""

    @abstractmethod
    def set(self, high: bool) -> None:
        """Set its level."""
