"""What a kind of device must be able to do."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol

import mujoco

from sitaf_bridge.world.description.yaml_block import Block, Problems


@dataclass(frozen=True)
class DeviceDeclaration:
    """What a world description says of a device; each kind adds its own fields."""

    name: str
    kind: str
    line: int


@dataclass(frozen=True)
class Reading:
    """What one device reads at the current step; each kind adds its own fields."""

    device: str


class Bank(Protocol):
    """All devices of one kind in one world, bound to its model. Holds no state: readings depend on the data only."""

    def read(self, model: mujoco.MjModel, data: mujoco.MjData) -> Sequence[Reading]:
        """The readings, in the order of declaration, of data that `mj_forward` has brought up to date."""
        ...


class DeviceKind(Protocol):
    """A kind of device."""

    @property
    def name(self) -> str:
        """As it stands in `kind:`."""
        ...

    def declare(self, name: str, block: Block) -> DeviceDeclaration | None:
        """Read a declaration; None after noting what is wrong with it."""
        ...

    def bind(self, model: mujoco.MjModel, declarations: Sequence[DeviceDeclaration], problems: Problems) -> Bank:
        """Find the devices in a model, noting those that are not there; the bank serves only if none was noted."""
        ...
