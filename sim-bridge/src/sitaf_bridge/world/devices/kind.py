"""The interface of device kinds."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple, Protocol

import mujoco

from sitaf_bridge.errors import InvalidRequest
from sitaf_bridge.world.description.yaml_block import Block, Problems

# Numbers that each device stores in the userdata of the simulation, so that they are part of its state.
KNOBS = ("noise", "delay", "level")


@dataclass(frozen=True)
class DeviceDeclaration:
    """The declaration of a device; each kind adds its own fields.

    `noise` is a standard deviation in the unit of the readings, `delay` is in seconds, the meaning of `level`
    depends on the kind. `slot` numbers the devices from the last one, starting at 1, and locates their userdata.
    """

    name: str
    kind: str
    line: int
    noise: float = field(default=0.0, kw_only=True)
    delay: float = field(default=0.0, kw_only=True)
    level: float = field(default=0.0, kw_only=True)
    slot: int = field(default=0, kw_only=True)

    def address(self, model: mujoco.MjModel, knob: str) -> int:
        """The index of a knob in the userdata."""
        return int(model.nuserdata) - len(KNOBS) * self.slot + KNOBS.index(knob)


# The smallest and the largest valid number, both inclusive.
Limits = tuple[float, float]


@dataclass(frozen=True)
class Bound:
    """The limits of a sum of `factors`, each times its number of a command."""

    factors: Mapping[str, float]
    limits: Limits


@dataclass(frozen=True)
class Accepted:
    """The commands that a device is known to accept: numbers with their limits, and limits of several together."""

    numbers: Mapping[str, Limits]
    bounds: Sequence[Bound] = ()


class Reading(NamedTuple):
    """The reading of one device at the current step: the fields of its kind, booleans as 0 and 1."""

    device: DeviceDeclaration
    values: tuple[float, ...]


class Command(NamedTuple):
    """A command to a device: `form` is joint, drive, gripper or level; numbers by name in SI units."""

    device: str
    form: str
    numbers: Mapping[str, float]


class Bank(Protocol):
    """All devices of one kind in one world, bound to its model. Stateless: readings depend on the data only."""

    def read(self, model: mujoco.MjModel, data: mujoco.MjData) -> Sequence[Reading]:
        """The readings in the order of declaration, from data after `mj_forward`."""
        ...


class ActuatorBank(Bank, Protocol):
    """Devices that accept commands."""

    def write(self, model: mujoco.MjModel, data: mujoco.MjData, command: Command) -> None:
        """Run a command with finite numbers. Raises InvalidRequest, UnreachableValue."""
        ...

    def accepts(self, model: mujoco.MjModel, device: str) -> Accepted:
        """The commands that a device accepts."""
        ...

    def actuators(self, device: str) -> tuple[int, ...]:
        """The actuators of the model that a device drives."""
        ...


class DeviceKind:
    """A kind of device."""

    # The value of the key `kind`.
    name: str
    # Whether its values are booleans, which have no noise and no NaN.
    truths = False
    # Whether it is an image, which is read by a separate call.
    image = False
    # The form of the commands that it accepts.
    takes: str | None = None

    def declare(self, name: str, block: Block) -> DeviceDeclaration | None:
        """Read a declaration; None after reporting an error."""
        raise NotImplementedError

    def bind(self, model: mujoco.MjModel, declarations: Sequence[DeviceDeclaration], problems: Problems) -> Bank:
        """Bind the devices to a model and report errors; the bank is valid only without errors."""
        raise NotImplementedError

    def fields(self, declaration: DeviceDeclaration) -> tuple[str, ...]:
        """The names of the numbers in a reading."""
        raise NotImplementedError

    def limited(self, declaration: DeviceDeclaration, values: tuple[float, ...]) -> tuple[float, ...]:
        """Apply the device's limits to values that were changed by noise or a fault."""
        return values


def expected_form(command: Command, form: str) -> Mapping[str, float]:
    """The numbers of a command of the expected form. Raises InvalidRequest."""
    if command.form != form:
        raise InvalidRequest(f"commands: the device {command.device} takes a {form!r} command, not {command.form!r}")
    return command.numbers
