"""The devices of a simulated robot, which read the numbers of the current step."""

from __future__ import annotations

from typing import Any, Protocol

from sitaf_runtime.robot import actuators, sensors
from sitaf_runtime.robot.geometry import Quaternion, Vector
from sitaf_runtime.simulation.wire.sitaf.sim.v1 import simulation_pb2 as pb


class Access(Protocol):
    """Access of one device to its readings and the simulator; measured as hardware time."""

    def number(self, index: int) -> float:
        """One number of the reading."""
        ...

    def numbers(self, start: int, count: int) -> list[float]:
        """Several numbers of the reading."""
        ...

    def after_commands(self) -> Access:
        """The same access, after pending commands were sent: for numbers that commands change before time advances."""
        ...

    def setting(self) -> Any:
        """The reading at the start of the session, which contains the constants of the device."""
        ...

    def write(self, command: pb.DeviceCommand) -> None:
        """Send a command to the device."""
        ...

    def look(self) -> pb.Reading:
        """The current image of the camera."""
        ...


class _Simulated:
    """Base of all simulated devices."""

    def __init__(self, name: str, access: Access) -> None:
        self.name = name
        self._access = access

    def _vector(self, start: int) -> Vector:
        return Vector(*self._access.numbers(start, 3))

    def _quaternion(self, start: int) -> Quaternion:
        return Quaternion(*self._access.numbers(start, 4))


class Range(_Simulated, sensors.RangeSensor):
    """A range sensor."""

    def range(self) -> float:
        return self._access.number(0)

    def min_range(self) -> float:
        return self._access.setting().range.min_range_m

    def max_range(self) -> float:
        return self._access.setting().range.max_range_m


class Scanner(_Simulated, sensors.LaserScanner):
    """A laser scanner."""

    def angle_min(self) -> float:
        return self._access.setting().laser_scan.angle_min

    def angle_max(self) -> float:
        return self._access.setting().laser_scan.angle_max

    def angle_increment(self) -> float:
        return self._access.setting().laser_scan.angle_increment

    def min_range(self) -> float:
        return self._access.setting().laser_scan.range_min_m

    def max_range(self) -> float:
        return self._access.setting().laser_scan.range_max_m

    def ranges(self) -> list[float]:
        return self._access.numbers(0, -1)


class Imu(_Simulated, sensors.ImuSensor):
    """An inertial measurement unit."""

    def orientation(self) -> Quaternion:
        return self._quaternion(0)

    def angular_velocity(self) -> Vector:
        return self._vector(4)

    def linear_acceleration(self) -> Vector:
        self._access.after_commands()
        return self._vector(7)


class Encoder(_Simulated, sensors.JointEncoder):
    """A joint's encoder."""

    def position(self) -> float:
        return self._access.number(0)

    def velocity(self) -> float:
        return self._access.number(1)


class Pose(_Simulated, sensors.PoseSensor):
    """A pose sensor."""

    def position(self) -> Vector:
        return self._vector(0)

    def orientation(self) -> Quaternion:
        return self._quaternion(3)


class Force(_Simulated, sensors.ForceTorqueSensor):
    """A force and torque sensor."""

    def force(self) -> Vector:
        self._access.after_commands()
        return self._vector(0)

    def torque(self) -> Vector:
        self._access.after_commands()
        return self._vector(3)


class Bumper(_Simulated, sensors.ContactSensor):
    """A contact sensor."""

    def is_pressed(self) -> bool:
        return self._access.after_commands().number(0) > 0.5

    def force(self) -> float:
        return self._access.after_commands().number(1)


class Compass(_Simulated, sensors.Magnetometer):
    """A magnetometer."""

    def field(self) -> Vector:
        return self._vector(0)


class Accumulator(_Simulated, sensors.Battery):
    """A battery."""

    def voltage(self) -> float:
        return self._access.number(0)

    def current(self) -> float:
        return self._access.number(1)

    def charge(self) -> float:
        return self._access.number(2)

    def percentage(self) -> float:
        return self._access.number(3)


class Eye(_Simulated, sensors.Camera):
    """A camera."""

    def image(self) -> sensors.Image:
        image = self._access.look().image
        return sensors.Image(image.width, image.height, image.encoding, image.data)


class Motor(Encoder, actuators.JointMotor):
    """A joint's motor."""

    def effort(self) -> float:
        return self._access.after_commands().number(2)

    def set_position(self, target: float) -> None:
        self._access.write(pb.DeviceCommand(joint=pb.JointCommand(position=target)))

    def set_velocity(self, target: float) -> None:
        self._access.write(pb.DeviceCommand(joint=pb.JointCommand(velocity=target)))

    def set_effort(self, target: float) -> None:
        self._access.write(pb.DeviceCommand(joint=pb.JointCommand(effort=target)))


class Drive(_Simulated, actuators.DifferentialDrive):
    """A differential drive."""

    def linear(self) -> float:
        return self._access.number(0)

    def angular(self) -> float:
        return self._access.number(1)

    def left_position(self) -> float:
        return self._access.number(2)

    def right_position(self) -> float:
        return self._access.number(3)

    def drive(self, linear: float, angular: float) -> None:
        self._access.write(pb.DeviceCommand(drive=pb.DriveCommand(linear=linear, angular=angular)))


class Hand(_Simulated, actuators.Gripper):
    """A gripper."""

    def width(self) -> float:
        return self._access.number(0)

    def effort(self) -> float:
        return self._access.after_commands().number(1)

    def move(self, width: float) -> None:
        self._access.write(pb.DeviceCommand(gripper=pb.GripperCommand(width_m=width)))


class Line(_Simulated, actuators.DigitalLine):
    """A digital line."""

    def is_high(self) -> bool:
        return self._access.after_commands().number(0) > 0.5

    def set(self, high: bool) -> None:
        self._access.write(pb.DeviceCommand(level=high))
