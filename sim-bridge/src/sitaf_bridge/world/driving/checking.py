"""Checks of requests before anything is changed."""

import math
from collections.abc import Iterable, Mapping, Sequence

from sitaf_bridge.errors import InvalidRequest, LimitReached, UnreachableValue
from sitaf_bridge.world.driving.commanding import check_saturable
from sitaf_bridge.world.sensing.fault_names import SATURATED, check_fault_name, check_fault_value, is_fault
from sitaf_bridge.world.world import World

MAX_STEPS = 10_000_000
# Runs in one call, each with its commands.
MAX_RUNS = 1_001


def check_values(world: World, values: Mapping[str, float]) -> None:
    """Check parameter values. Raises InvalidRequest, UnreachableValue."""
    check_names(world, values)
    for name, value in values.items():
        if not math.isfinite(value):
            raise InvalidRequest(f"parameter {name}: {value} is not a finite number")
    for name, value in values.items():
        if is_fault(name):
            check_fault_value(name, check_fault_name(name, world.description), value)
            continue
        parameter = world.description.parameters[name]
        if not parameter.low <= value <= parameter.high:
            raise UnreachableValue(
                f"parameter {name}: {value:g} {parameter.unit} is outside its range "
                f"[{parameter.low:g}, {parameter.high:g}]"
            )


def check_names(world: World, names: Iterable[str]) -> None:
    """Raise InvalidRequest for unknown parameter names, and for faults that do not fit their device."""
    parameters = world.description.parameters
    unknown: list[str] = []
    for name in names:
        if is_fault(name):
            fault = check_fault_name(name, world.description)
            if fault.kind == SATURATED:
                check_saturable(fault.device, world)
        elif name not in parameters:
            unknown.append(name)
    if unknown:
        known = ", ".join(parameters) or "none"
        raise InvalidRequest(f"unknown parameter {', '.join(unknown)}; parameters of this world: {known}")


def steps_in(world: World, duration_ns: int, shown: str) -> int:
    """Convert nanoseconds to steps, rounded up. Raises InvalidRequest, LimitReached."""
    if duration_ns < 0:
        raise InvalidRequest(f"{shown}: {duration_ns} is negative")
    steps = -(-duration_ns // world.timestep_ns)
    check_step_count(steps)
    return steps


def check_runs(steps: Sequence[int]) -> None:
    """Check the steps of each run of one call. Raises InvalidRequest, LimitReached."""
    if len(steps) > MAX_RUNS:
        raise LimitReached(f"later: {len(steps) - 1} entries; the limit is {MAX_RUNS - 1}")
    if min(steps) < 1:
        raise InvalidRequest("steps: must be at least 1")
    check_step_count(sum(steps))


def check_step_count(steps: int) -> None:
    """Raises LimitReached."""
    if steps > MAX_STEPS:
        raise LimitReached(f"{steps} steps in one call; the limit is {MAX_STEPS}")
