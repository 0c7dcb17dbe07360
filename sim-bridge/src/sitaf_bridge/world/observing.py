"""Binds observations to a model."""

import math
from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass

import mujoco
import numpy as np

from sitaf_bridge.world.description.declaration import Description
from sitaf_bridge.world.description.observation import (
    AXES,
    LINES,
    QUATERNION,
    Coordinate,
    DeviceNumber,
    Distance,
    Observation,
    Orientation,
    Touch,
    Velocity,
)
from sitaf_bridge.world.devices import KINDS, Reading
from sitaf_bridge.world.parameters.settings import NoSuchSetting, name_to_id

BODY, GEOM = mujoco.mjtObj.mjOBJ_BODY, mujoco.mjtObj.mjOBJ_GEOM
Measure = Callable[[mujoco.MjModel, mujoco.MjData, Sequence[Reading]], float]


@dataclass(frozen=True)
class BoundObservation:
    """Measures an observation; `place` is body and axis if it is a plain coordinate of `xpos`."""

    measure: Measure
    place: tuple[int, int] | None = None


def find_observation(model: mujoco.MjModel, description: Description, observation: Observation) -> BoundObservation:
    """Bind a declared observation to a model. Raises NoSuchSetting."""
    match observation.sight:
        case Coordinate(entity, axis):
            return _coordinate(_body(model, entity), AXES.index(axis))
        case Velocity(entity, axis):
            return BoundObservation(_velocity(_body(model, entity), AXES.index(axis)))
        case Orientation(entity, part):
            return BoundObservation(_orientation(_body(model, entity), QUATERNION.index(part)))
        case DeviceNumber(device, index, _):
            names = [d.name for d in description.devices.values() if not KINDS[d.kind].image]
            position = names.index(device)
            return BoundObservation(lambda _model, _data, readings: readings[position].values[index])
        case Touch(first, second):
            return BoundObservation(_touch(find_solids(model, first), find_solids(model, second)))
        case Distance(first, second):
            return BoundObservation(_distance(_body(model, first), _body(model, second)))


def find_solids(model: mujoco.MjModel, name: str) -> frozenset[int]:
    """The ids of the geom with this name or, if there is none, of all geoms of the body with this name.

    Robots from packages often have geoms without names. Raises NoSuchSetting.
    """
    if mujoco.mj_name2id(model, GEOM, name) >= 0:
        return frozenset([name_to_id(model, GEOM, "geom", name)])
    if mujoco.mj_name2id(model, BODY, name) < 0:
        raise NoSuchSetting(f"the MJCF has neither a geom nor a body {name!r}")
    return frozenset(np.flatnonzero(model.geom_bodyid == name_to_id(model, BODY, "body", name)).tolist())


def touching(data: mujoco.MjData, first: Collection[int], second: Collection[int]) -> bool:
    """Whether any of the first geoms touches any of the second."""
    if not data.ncon:
        return False
    contact = data.contact
    # Lists and sets, because there are few contacts: 2 us instead of 60.
    return any(
        dist <= 0 and ((one in first and other in second) or (one in second and other in first))
        for (one, other), dist in zip(contact.geom.tolist(), contact.dist.tolist(), strict=True)
    )


def _body(model: mujoco.MjModel, name: str) -> int:
    return name_to_id(model, BODY, "body", name)


def _coordinate(body: int, axis: int) -> BoundObservation:
    if axis < len(LINES):
        return BoundObservation(lambda _model, data, _readings: data.xpos.item(body, axis), (body, axis))

    def angle(_model: mujoco.MjModel, data: mujoco.MjData, _readings: Sequence[Reading]) -> float:
        m = data.xmat[body].tolist()
        match AXES[axis]:
            case "roll":
                return math.atan2(m[7], m[8])
            case "pitch":
                return math.asin(max(-1.0, min(1.0, -m[6])))
            case _:
                return math.atan2(m[3], m[0])

    return BoundObservation(angle)


def _velocity(body: int, axis: int) -> Measure:
    # In MuJoCo's spatial vectors the angular velocity comes first.
    index = axis + 3 if axis < len(LINES) else axis - 3

    def measure(model: mujoco.MjModel, data: mujoco.MjData, _readings: Sequence[Reading]) -> float:
        velocity = np.empty(6)
        mujoco.mj_objectVelocity(model, data, mujoco.mjtObj.mjOBJ_XBODY, body, velocity, 0)
        return velocity.item(index)

    return measure


def _orientation(body: int, part: int) -> Measure:
    def measure(_model: mujoco.MjModel, data: mujoco.MjData, _readings: Sequence[Reading]) -> float:
        w, x, y, z = data.xquat[body].tolist()
        # q and -q are the same orientation.
        return math.copysign(1.0, w) * (x, y, z, w)[part]

    return measure


def _touch(first: Collection[int], second: Collection[int]) -> Measure:
    return lambda _model, data, _readings: float(touching(data, first, second))


def _distance(first: int, second: int) -> Measure:
    return lambda _model, data, _readings: float(np.linalg.norm(data.xpos[first] - data.xpos[second]))
