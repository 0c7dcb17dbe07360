"""Sensors. `name` is the device's name in the world description."""

from abc import ABC, abstractmethod
from dataclasses import dataclass

from sitaf_runtime.robot.geometry import Quaternion, Vector


class Device(ABC):  # noqa: B024  # each kind has its own methods
    """A part of the robot's hardware."""

    __slots__ = ("name",)

    def __init__(self, name: str) -> None:
        self.name = name


class RangeSensor(Device):
    """Measures the distance to the nearest surface along its ray; shape of `sensor_msgs/Range`."""

    __slots__ = ()

    @abstractmethod
    def range(self) -> float:
        """The distance at the current step in metres.

        As in REP-117: positive infinity when nothing is within `max_range()`, negative infinity when something is
        nearer than `min_range()` or around the sensor, NaN when the reading failed.
        """

    @abstractmethod
    def min_range(self) -> float:
        """Smallest distance that the sensor measures, in metres, inclusive."""

    @abstractmethod
    def max_range(self) -> float:
        """Largest distance that the sensor measures, in metres, inclusive."""


class LaserScanner(Device):
    """A laser scanner; shape of `sensor_msgs/LaserScan`."""

    __slots__ = ()

    @abstractmethod
    def angle_min(self) -> float:
        """Angle of the first ray in radians, counterclockwise from straight ahead."""

    @abstractmethod
    def angle_max(self) -> float:
        """Angle of the last ray in radians."""

    @abstractmethod
    def angle_increment(self) -> float:
        """Angle between two rays in radians."""

    @abstractmethod
    def min_range(self) -> float:
        """Smallest distance that it measures, in metres."""

    @abstractmethod
    def max_range(self) -> float:
        """Largest distance that it measures, in metres."""

    @abstractmethod
    def ranges(self) -> list[float]:
        """Distances in metres, one for each ray, in a new list; infinities and NaN as in REP-117."""


class ImuSensor(Device):
    """An inertial measurement unit; shape of `sensor_msgs/Imu`, in its own frame."""

    __slots__ = ()

    @abstractmethod
    def orientation(self) -> Quaternion:
        """Its orientation in the world."""

    @abstractmethod
    def angular_velocity(self) -> Vector:
        """Radians per second."""

    @abstractmethod
    def linear_acceleration(self) -> Vector:
        """Metres per second squared, including gravity: at rest it points upwards."""


class JointEncoder(Device):
    """An encoder of a joint."""

    __slots__ = ()

    @abstractmethod
    def position(self) -> float:
        """Radians, or metres for a prismatic joint."""

    @abstractmethod
    def velocity(self) -> float:
        """Radians or metres per second."""


class PoseSensor(Device):
    """A sensor of position and orientation in the world."""

    __slots__ = ()

    @abstractmethod
    def position(self) -> Vector:
        """Metres."""

    @abstractmethod
    def orientation(self) -> Quaternion:
        """Its orientation in the world."""


class ForceTorqueSensor(Device):
    """A force and torque sensor, in its own frame."""

    __slots__ = ()

    @abstractmethod
    def force(self) -> Vector:
        """Newtons."""

    @abstractmethod
    def torque(self) -> Vector:
        """Newton metres."""


class ContactSensor(Device):
    """A contact sensor, such as a bumper."""

    __slots__ = ()

    @abstractmethod
    def is_pressed(self) -> bool:
        """Whether it is pressed."""

    @abstractmethod
    def force(self) -> float:
        """Contact force in newtons."""


@dataclass(frozen=True, slots=True)
class Image:
    """An image, row by row from the top.

    `encoding` is `rgb8` (bytes red, green, blue) or `32FC1` (metres, as little-endian floats).
    """

    width: int
    height: int
    encoding: str
    data: bytes


class Camera(Device):
    """A camera; shape of `sensor_msgs/Image`. Unlike other devices, each call reads it from the simulator."""

    __slots__ = ()

    @abstractmethod
    def image(self) -> Image:
        """The image at the current step."""


class Magnetometer(Device):
    """A magnetometer, in its own frame."""

    __slots__ = ()

    @abstractmethod
    def field(self) -> Vector:
        """Magnetic field in tesla."""


class Battery(Device):
    """A battery; shape of `sensor_msgs/BatteryState`."""

    __slots__ = ()

    @abstractmethod
    def voltage(self) -> float:
        """Volts."""

    @abstractmethod
    def current(self) -> float:
        """Amperes, negative while it discharges."""

    @abstractmethod
    def charge(self) -> float:
        """Ampere hours."""

    @abstractmethod
    def percentage(self) -> float:
        """0 to 1."""
