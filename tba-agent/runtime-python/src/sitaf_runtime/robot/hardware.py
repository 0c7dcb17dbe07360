"""The robot's hardware as a component under test sees it."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from sitaf_runtime.robot.actuators import DifferentialDrive, DigitalLine, Gripper, JointMotor
    from sitaf_runtime.robot.sensors import (
        Battery,
        Camera,
        ContactSensor,
        ForceTorqueSensor,
        ImuSensor,
        JointEncoder,
        LaserScanner,
        Magnetometer,
        PoseSensor,
        RangeSensor,
    )

# Global because a process runs a single suite.
_current: Hardware | None = None


def set_current(hardware: Hardware | None) -> None:
    """Set the value of `Hardware.current()`."""
    global _current  # noqa: PLW0603
    _current = hardware


class Hardware(ABC):
    """The devices of a robot, by name.

    A component gets it as a constructor argument of this type, or from `Hardware.current()`. Only the test driver
    advances time. Between two steps of the simulation all readings stay the same, and reading needs no round trip to
    the simulator.

    Each accessor raises ValueError when the robot has no such device; the message lists the existing ones.
    """

    @staticmethod
    def current() -> Hardware:
        """The hardware of the running test, for components whose constructor cannot take it.

        Raises RuntimeError when no test with a simulated world is running.
        """
        if _current is None:
            raise RuntimeError(
                "there is no virtual hardware: no test with a simulated world is running"
                " (does the activity name a world?)"
            )
        return _current

    @abstractmethod
    def range_sensor(self, name: str) -> RangeSensor:
        """A sensor that measures one distance, such as an infrared or an ultrasonic sensor."""

    @abstractmethod
    def laser_scanner(self, name: str) -> LaserScanner:
        """A laser scanner."""

    @abstractmethod
    def imu(self, name: str) -> ImuSensor:
        """An inertial measurement unit."""

    @abstractmethod
    def joint_encoder(self, name: str) -> JointEncoder:
        """The encoder of a joint."""

    @abstractmethod
    def pose_sensor(self, name: str) -> PoseSensor:
        """A sensor of position and orientation."""

    @abstractmethod
    def force_torque_sensor(self, name: str) -> ForceTorqueSensor:
        """A force and torque sensor."""

    @abstractmethod
    def contact_sensor(self, name: str) -> ContactSensor:
        """A contact sensor, such as a bumper."""

    @abstractmethod
    def camera(self, name: str) -> Camera:
        """A camera."""

    @abstractmethod
    def magnetometer(self, name: str) -> Magnetometer:
        """A magnetometer."""

    @abstractmethod
    def battery(self, name: str) -> Battery:
        """A battery."""

    @abstractmethod
    def joint_motor(self, name: str) -> JointMotor:
        """A motor at a joint."""

    @abstractmethod
    def differential_drive(self, name: str) -> DifferentialDrive:
        """A base on two driven wheels."""

    @abstractmethod
    def gripper(self, name: str) -> Gripper:
        """A gripper."""

    @abstractmethod
    def digital_line(self, name: str) -> DigitalLine:
        """A digital input or output."""

    @abstractmethod
    def time(self) -> float:
        """Simulation time in seconds since the beginning of the case."""

    @abstractmethod
    def sleep(self, seconds: float) -> None:
        """Wait in simulation time, rounded up to whole steps; the simulation advances meanwhile."""

    @property
    @abstractmethod
    def devices(self) -> frozenset[str]:
        """Names of all devices."""
