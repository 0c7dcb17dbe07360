"""The state of a world at one step, and the scopes of a reset."""

import enum
from collections.abc import Mapping
from dataclasses import dataclass

from sitaf_bridge.world.description.declaration import Description
from sitaf_bridge.world.devices import Reading


class ResetScope(enum.Enum):
    """What a reset restores."""

    ALL = "time, state and parameters"
    TIME = "only the clock"
    STATE = "positions, velocities and controls"


@dataclass(frozen=True)
class WorldState:
    """A snapshot of the world: readings by device except cameras, observations by name, in the order of declaration."""

    declared: Description
    step: int
    time_ns: int
    readings: tuple[Reading, ...]
    observations: Mapping[str, float]
