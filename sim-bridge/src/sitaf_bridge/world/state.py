"""What a simulation looks like at one step, and how far it can be put back."""

import enum
from collections.abc import Mapping
from dataclasses import dataclass

from sitaf_bridge.world.description.declaration import Description
from sitaf_bridge.world.devices import Reading


class ResetScope(enum.Enum):
    """What a reset puts back."""

    ALL = "time, state and parameters"
    TIME = "only the clock"
    STATE = "positions, velocities and controls"


@dataclass(frozen=True)
class WorldState:
    """The frozen world: readings by device but for cameras, observations by name, in the order of declaration."""

    declared: Description
    step: int
    time_ns: int
    readings: tuple[Reading, ...]
    observations: Mapping[str, float]
