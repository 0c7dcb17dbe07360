"""A robot as the compiler gets it."""

from collections.abc import Mapping
from dataclasses import dataclass, field

from sitaf_bridge.world.description.robot import Robot


@dataclass(frozen=True)
class Drive:
    """An actuator for a joint of a URDF. `low` and `high` limit the position, in radians or metres; 0 is no limit."""

    joint: str
    mode: str
    limited: bool
    low: float
    high: float
    effort: float
    velocity: float


@dataclass(frozen=True)
class RobotModel:
    """The text of a robot's model, and its files by their names in the model.

    `included` are the MJCF files that it includes. URDF has no actuators: `drives` are added.
    """

    robot: Robot
    text: str
    assets: Mapping[str, bytes] = field(repr=False)
    included: Mapping[str, bytes] = field(default_factory=dict, repr=False)
    urdf: bool = False
    drives: tuple[Drive, ...] = ()
