"""What a kind of device must be able to do."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple, Protocol

import mujoco

from sitaf_bridge.errors import InvalidRequest
from sitaf_bridge.world.description.yaml_block import Block, Problems

# What each device keeps in the userdata of the simulation, so that it is part of the state: three numbers.
KNOBS = ("noise", "delay", "level")


@dataclass(frozen=True)
class DeviceDeclaration:
    """What a world description says of a device; each kind adds its own fields.

    `noise` is a standard deviation in the unit of the readings, `delay` is in seconds, `level` what the kind makes of
    it. `slot` counts devices from the last, beginning with 1: where its knobs are in the userdata.
    """

    name: str
    kind: str
    line: int
    noise: float = field(default=0.0, kw_only=True)
    delay: float = field(default=0.0, kw_only=True)
    level: float = field(default=0.0, kw_only=True)
    slot: int = field(default=0, kw_only=True)

    def address(self, model: mujoco.MjModel, knob: str) -> int:
        """Where a knob is in the userdata."""
        return int(model.nuserdata) - len(KNOBS) * self.slot + KNOBS.index(knob)


class Reading(NamedTuple):
    """What one device reads at the current step: the numbers that its kind names, truth values as 0 and 1."""

    device: DeviceDeclaration
    values: tuple[float, ...]


@dataclass(frozen=True)
class Command:
    """What a device is told: `form` is joint, drive, gripper or level; numbers by name in SI units."""

    device: str
    form: str
    numbers: Mapping[str, float]


class Bank(Protocol):
    """All devices of one kind in one world, bound to its model. Holds no state: readings depend on the data only."""

    def read(self, model: mujoco.MjModel, data: mujoco.MjData) -> Sequence[Reading]:
        """The readings, in the order of declaration, of data that `mj_forward` has brought up to date."""
        ...


class ActuatorBank(Bank, Protocol):
    """Devices that can be commanded."""

    def write(self, model: mujoco.MjModel, data: mujoco.MjData, command: Command) -> None:
        """Carry out a command whose numbers are finite. Raises InvalidRequest, UnreachableValue."""
        ...


class DeviceKind:
    """A kind of device."""

    # As it stands in `kind:`.
    name: str
    # Whether its values are truth values, which have no noise and no NaN.
    truths = False
    # Whether it is an image, read by name only.
    image = False
    # The form of the commands that it takes.
    takes: str | None = None

    def declare(self, name: str, block: Block) -> DeviceDeclaration | None:
        """Read a declaration; None after noting what is wrong with it."""
        raise NotImplementedError

    def bind(self, model: mujoco.MjModel, declarations: Sequence[DeviceDeclaration], problems: Problems) -> Bank:
        """Find the devices in a model, noting those that are not there; the bank serves only if none was noted."""
        raise NotImplementedError

    def fields(self, declaration: DeviceDeclaration) -> tuple[str, ...]:
        """The names of the numbers in a reading."""
        raise NotImplementedError

    def limited(self, declaration: DeviceDeclaration, values: tuple[float, ...]) -> tuple[float, ...]:
        """What the device makes of numbers that noise or a fault has moved."""
        return values


def expected_form(command: Command, form: str) -> Mapping[str, float]:
    """The numbers of a command of the right form. Raises InvalidRequest."""
    if command.form != form:
        raise InvalidRequest(f"commands: the device {command.device} takes a {form!r} command, not {command.form!r}")
    return command.numbers
