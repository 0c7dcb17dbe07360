"""Actuators. A command holds until the next one and takes effect when simulation time advances.

An unsupported command, or one beyond the limits of the device, raises a ValueError.
"""

from abc import abstractmethod

from sitaf_runtime.robot.sensors import Device, JointEncoder


class JointMotor(JointEncoder):
    """A motor of a joint. The world description defines which command it supports."""

    __slots__ = ()

    @abstractmethod
    def effort(self) -> float:
        """Measured effort in newton metres or newtons."""

    @abstractmethod
    def set_position(self, target: float) -> None:
        """Command a position in radians or metres."""

    @abstractmethod
    def set_velocity(self, target: float) -> None:
        """Command a velocity in radians or metres per second."""

    @abstractmethod
    def set_effort(self, target: float) -> None:
        """Command an effort in newton metres or newtons."""


class DifferentialDrive(Device):
    """A mobile base with two driven wheels."""

    __slots__ = ()

    @abstractmethod
    def linear(self) -> float:
        """Measured linear speed in metres per second, forward."""

    @abstractmethod
    def angular(self) -> float:
        """Measured angular speed in radians per second, counterclockwise."""

    @abstractmethod
    def left_position(self) -> float:
        """Rotation of the left wheel in radians."""

    @abstractmethod
    def right_position(self) -> float:
        """Rotation of the right wheel in radians."""

    @abstractmethod
    def drive(self, linear: float, angular: float) -> None:
        """Command a linear speed in m/s and an angular speed in rad/s."""


class Gripper(Device):
    """A gripper with two fingers."""

    __slots__ = ()

    @abstractmethod
    def width(self) -> float:
        """Measured distance between the fingers in metres."""

    @abstractmethod
    def effort(self) -> float:
        """Force of the fingers in newtons; closing is negative."""

    @abstractmethod
    def move(self, width: float) -> None:
        """Move to a width in metres."""


class DigitalLine(Device):
    """A digital input or output."""

    __slots__ = ()

    @abstractmethod
    def is_high(self) -> bool:
        """Its level."""

    @abstractmethod
    def set(self, high: bool) -> None:
        """Set its level."""
