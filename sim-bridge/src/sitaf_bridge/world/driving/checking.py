"""What can be refused before anything is changed."""

import math
from collections.abc import Iterable, Mapping

from sitaf_bridge.errors import InvalidRequest, LimitReached, UnreachableValue
from sitaf_bridge.world.world import World

MAX_STEPS = 10_000_000


def check_values(world: World, values: Mapping[str, float]) -> None:
    """Raises InvalidRequest, UnreachableValue for values of parameters that cannot be set."""
    refuse_unknown(world, values)
    for name, value in values.items():
        if not math.isfinite(value):
            raise InvalidRequest(f"parameter {name}: {value} is not a finite number")
    for name, value in values.items():
        parameter = world.description.parameters[name]
        if not parameter.low <= value <= parameter.high:
            raise UnreachableValue(
                f"parameter {name}: {value:g} {parameter.unit} is outside its range "
                f"[{parameter.low:g}, {parameter.high:g}]"
            )


def refuse_unknown(world: World, names: Iterable[str]) -> None:
    """Raises InvalidRequest for names that are not parameters."""
    parameters = world.description.parameters
    unknown = [name for name in names if name not in parameters]
    if unknown:
        known = ", ".join(parameters) or "none"
        raise InvalidRequest(f"unknown parameter {', '.join(unknown)}; parameters of this world: {known}")


def steps_in(world: World, duration_ns: int, shown: str) -> int:
    """Nanoseconds as steps, rounded up. Raises InvalidRequest, LimitReached."""
    if duration_ns < 0:
        raise InvalidRequest(f"{shown}: {duration_ns} is negative")
    steps = -(-duration_ns // world.timestep_ns)
    refuse_too_many(steps)
    return steps


def refuse_too_many(steps: int) -> None:
    """Raises LimitReached."""
    if steps > MAX_STEPS:
        raise LimitReached(f"{steps} steps in one call; the limit is {MAX_STEPS}")
