"""What a device of a provider can do."""

import math
import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

UNLIMITED = math.inf


class DeviceError(Exception):
    """The device does not answer, or not as expected; the message goes to the test."""


@dataclass(frozen=True)
class Limits:
    """A number of a command: its SI unit, and its smallest and largest value, both inclusive."""

    unit: str
    low: float = -UNLIMITED
    high: float = UNLIMITED


@dataclass(frozen=True)
class Reading:
    """Numbers in the order of `Device.fields`; `taken` is when they were measured, on `time.monotonic()`."""

    values: Sequence[float]
    taken: float = field(default_factory=time.monotonic)


class Device:
    """One device. A subclass names its kind and fields, and implements what it can do.

    Calls come from several threads, but never two at a time for one device.
    """

    # The kind in the world's description, such as "range".
    kind: str
    # The names and units of the numbers in a reading.
    fields: Mapping[str, str]
    # The numbers that a command may contain; none for a sensor.
    commands: Mapping[str, Limits] = {}
    # The parameters of the world that `set` can set.
    parameters: Sequence[str] = ()
    # Whether `read` needs what the simulated device measures; for rigs that stimulate a sensor.
    follows_simulation: bool = False

    # What the simulated device measures, before each `read` of a device that follows the simulation.
    simulated: Sequence[float] = ()

    def read(self) -> Reading | Sequence[float]:
        """The newest reading; plain numbers are measured now. Raises DeviceError."""
        raise NotImplementedError

    def check(self, numbers: Mapping[str, float]) -> None:
        """Refuse a command, whose numbers are within the limits, before any is carried out. Raises ValueError."""

    def command(self, numbers: Mapping[str, float]) -> None:
        """Follow a command, whose numbers are within the limits. Raises DeviceError."""
        raise DeviceError("takes no commands")

    def set(self, parameters: Mapping[str, float]) -> None:
        """Set parameters of the environment, and return when they are reached. Raises DeviceError, ValueError."""
        raise DeviceError("sets no parameters")

    def stop(self) -> None:
        """Bring the device into a safe state. Raises DeviceError."""

    def fault(self) -> str:
        """Why the device does not work; empty if it does."""
        return ""
