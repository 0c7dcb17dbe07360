"""Conditions that end an advance."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import mujoco
import numpy as np

from sitaf_bridge.errors import InvalidRequest
from sitaf_bridge.world.devices import KINDS, Reading
from sitaf_bridge.world.observing import find_solids, touching
from sitaf_bridge.world.parameters.settings import NoSuchSetting, name_to_id
from sitaf_bridge.world.world import World


@dataclass(frozen=True)
class Touching:
    """Two geoms, or the geoms of bodies, touch."""

    geom1: str
    geom2: str


@dataclass(frozen=True)
class Beyond:
    """A number of a device is above or below a value, exclusive."""

    device: str
    field: str
    value: float
    above: bool


@dataclass(frozen=True)
class Near:
    """The origins of two bodies are at most `within` metres apart."""

    body1: str
    body2: str
    within: float


@dataclass(frozen=True)
class AtTime:
    """A simulation time in nanoseconds is reached."""

    time_ns: int


Condition = Touching | Beyond | Near | AtTime
Predicate = Callable[[mujoco.MjData, int, Callable[[], Sequence[Reading]]], bool]


def bind_condition(condition: Condition, world: World, model: mujoco.MjModel) -> Predicate:
    """Bind a condition to a function of data, time in ns and readings on demand. Raises InvalidRequest."""
    try:
        match condition:
            case Touching():
                return _touching(condition, model)
            case Beyond():
                return _beyond(condition, world)
            case Near():
                return _near(condition, model)
            case AtTime():
                return lambda _data, now, _read: now >= condition.time_ns
    except NoSuchSetting as error:
        raise InvalidRequest(f"condition: {error}") from error


def _touching(condition: Touching, model: mujoco.MjModel) -> Predicate:
    first, second = (find_solids(model, name) for name in (condition.geom1, condition.geom2))
    return lambda data, _now, _read: touching(data, first, second)


def _near(condition: Near, model: mujoco.MjModel) -> Predicate:
    first, second = (name_to_id(model, mujoco.mjtObj.mjOBJ_BODY, "body", n) for n in (condition.body1, condition.body2))
    if not condition.within >= 0:
        raise InvalidRequest(f"condition: within_m: {condition.within} must be at least 0")

    def judge(data: mujoco.MjData, _now: int, _read: Callable[[], Sequence[Reading]]) -> bool:
        return bool(np.linalg.norm(data.xpos[first] - data.xpos[second]) <= condition.within)

    return judge


def _beyond(condition: Beyond, world: World) -> Predicate:
    device = world.description.devices.get(condition.device)
    if device is None:
        raise InvalidRequest(f"condition: no device {condition.device!r}")
    if condition.value != condition.value:
        raise InvalidRequest("condition: the bound is not a number")
    fields = KINDS[device.kind].fields(device)
    if not condition.field and len(fields) == 1:
        index = 0
    elif condition.field in fields:
        index = fields.index(condition.field)
    else:
        raise InvalidRequest(
            f"condition: field: {condition.field!r} is not a number of {condition.device}; "
            f"it has {', '.join(fields) or 'none'}"
        )

    def judge(_data: mujoco.MjData, _now: int, read: Callable[[], Sequence[Reading]]) -> bool:
        value = next(r.values[index] for r in read() if r.device.name == condition.device)
        return value > condition.value if condition.above else value < condition.value

    return judge
