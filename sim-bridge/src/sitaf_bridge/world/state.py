"""What a simulation looks like at one step."""

from collections.abc import Mapping
from dataclasses import dataclass

from sitaf_bridge.world.devices import Reading


@dataclass(frozen=True)
class WorldState:
    """The frozen world: readings by device, observations by name, both in the order of declaration."""

    step: int
    time_ns: int
    readings: tuple[Reading, ...]
    observations: Mapping[str, float]
