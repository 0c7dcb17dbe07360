"""Kind `range`: an infrared or ultrasonic sensor with one ray, bound to a MuJoCo range finder; after REP-117."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import mujoco
import numpy as np
from numpy.typing import NDArray

from sitaf_bridge.world.description.yaml_block import Block, Problems
from sitaf_bridge.world.devices.binding import part_of
from sitaf_bridge.world.devices.kind import DeviceDeclaration, DeviceKind, Reading
from sitaf_bridge.world.geometry.solids import HFIELD, SOLID_TYPES, TOUCH, Surroundings, cast, clearance, visible

DISTANCE_ONLY = 1 << int(mujoco.mjtRayDataField.mjRAYDATA_DIST)


@dataclass(frozen=True)
class RangeDeclaration(DeviceDeclaration):
    """`low` and `high` are the smallest and largest distance that the device can measure, in metres."""

    sensor: str
    low: float
    high: float


@dataclass(frozen=True)
class _Ray:
    """The ray of a bound device. `native`: MuJoCo's own range finder value can be used."""

    site: int
    address: int
    solids: tuple[int, ...]
    native: bool


class RangeKind(DeviceKind):
    """Kind `range`."""

    name = "range"

    def declare(self, name: str, block: Block) -> RangeDeclaration | None:
        """Keys `sensor`, `min`, `max`."""
        sensor, low, high = block.text("sensor"), block.number("min"), block.number("max")
        if sensor is None or low is None or high is None:
            return None
        if not 0 <= low < high:
            block.problem(f"{block.path}: min {low:g} and max {high:g} must be 0 <= min < max")
            return None
        return RangeDeclaration(name, self.name, block.line, sensor, low, high)

    def bind(self, model: mujoco.MjModel, declarations: Sequence[DeviceDeclaration], problems: Problems) -> "RangeBank":
        """Find the range finders."""
        found: list[tuple[RangeDeclaration, _Ray]] = []
        for declaration in declarations:
            assert isinstance(declaration, RangeDeclaration)  # noqa: S101  # declared by this kind
            ray = _find(model, declaration, problems)
            if ray is not None:
                found.append((declaration, ray))
        return RangeBank(model, found)

    def fields(self, declaration: DeviceDeclaration) -> tuple[str, ...]:
        """One distance."""
        return ("range",)

    def limited(self, declaration: DeviceDeclaration, values: tuple[float, ...]) -> tuple[float, ...]:
        """Apply the range limits as in REP-117."""
        assert isinstance(declaration, RangeDeclaration)  # noqa: S101
        return tuple(within(value, declaration.low, declaration.high) for value in values)


class RangeBank:
    """All range devices of a world."""

    def __init__(self, model: mujoco.MjModel, devices: Sequence[tuple[RangeDeclaration, _Ray]]) -> None:
        self._devices = tuple(devices)
        rays = [ray for _, ray in devices]
        self._surroundings = Surroundings(model, [ray.site for ray in rays], [ray.solids for ray in rays])

    @property
    def devices(self) -> list[RangeDeclaration]:
        """The devices in the order of the readings."""
        return [device for device, _ in self._devices]

    @property
    def native(self) -> bool:
        """Whether all distances can be read from MuJoCo's range finders."""
        return all(ray.native for _, ray in self._devices)

    def read_many(self, model: mujoco.MjModel, batch: Any, count: int) -> tuple[NDArray[np.float64], NDArray[np.bool_]]:
        """The readings of the first simulations of a `mujoco.batch.Batch`, (count, devices), where `native`.

        Also returns for which simulations the result is not valid, because a sensor touches something.
        """
        distance = batch.bind("sensordata")[:count][:, [ray.address for _, ray in self._devices]]
        inside, unsure = self._surroundings.many(model, batch, count)
        low, high = np.array([d.low for d, _ in self._devices]), np.array([d.high for d, _ in self._devices])
        seen = np.where(distance < low, -math.inf, distance + 0.0)
        seen = np.where((distance < 0) | (distance > high), math.inf, seen)
        return np.where(inside, -math.inf, seen), unsure

    def read(self, model: mujoco.MjModel, data: mujoco.MjData) -> Sequence[Reading]:
        """The distances at the current step."""
        inside, touching = self._surroundings(model, data)
        values = data.sensordata.tolist()
        distances = [values[ray.address] if ray.native else _own_ray(model, data, ray) for _, ray in self._devices]
        for index, geom in touching:
            # A ray that starts on a surface, or slightly behind it by rounding, may report the far side.
            entry = clearance(model, data, geom, *_line(data, self._devices[index][1].site))
            if entry is not None and abs(entry) <= TOUCH:
                distances[index] = max(entry, 0.0)
        return [
            Reading(d, (_measured(distance, d, around),))
            for (d, _), distance, around in zip(self._devices, distances, inside.tolist(), strict=True)
        ]


def _line(data: mujoco.MjData, site: int) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Origin and direction of a site's ray, which is its z axis."""
    return data.site_xpos[site], np.ascontiguousarray(data.site_xmat[site].reshape(3, 3)[:, 2])


def _measured(distance: float, declaration: RangeDeclaration, inside: bool) -> float:
    """The reading as in REP-117; `distance` is -1 if the ray hits nothing."""
    if math.isnan(distance):
        return math.nan
    if inside:
        return -math.inf
    if distance < 0 or distance > declaration.high:
        return math.inf
    # Adding zero turns the -0.0 of a touching ray into 0.0.
    return -math.inf if distance < declaration.low else distance + 0.0


def within(distance: float, low: float, high: float) -> float:
    """Apply the limits of a sensor to a distance, as in REP-117; NaN and infinities are unchanged."""
    if distance > high:
        return math.inf
    return -math.inf if distance < low else distance


def _own_ray(model: mujoco.MjModel, data: mujoco.MjData, ray: _Ray) -> float:
    """Like the range finder, but excludes all bodies of the sensor's rigid part instead of the site's body only."""
    origin, along = _line(data, ray.site)
    hits = (cast(model, data, geom, origin, along) for geom in ray.solids)
    return min((hit for hit in hits if hit >= 0), default=-1.0)


def _find(model: mujoco.MjModel, declaration: RangeDeclaration, problems: Problems) -> _Ray | None:
    where = f"devices.{declaration.name}.sensor"
    sensor = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_SENSOR, declaration.sensor)
    if sensor < 0:
        problems.add(declaration.line, f"{where}: the MJCF has no sensor {declaration.sensor!r}")
        return None
    if model.sensor_type[sensor] != mujoco.mjtSensor.mjSENS_RANGEFINDER:
        problems.add(declaration.line, f"{where}: {declaration.sensor!r} is not a rangefinder")
        return None
    reason = _unusable(model, sensor, declaration)
    if reason is not None:
        problems.add(declaration.line, f"{where}: the rangefinder {declaration.sensor!r} {reason}")
        return None
    site = int(model.sensor_objid[sensor])
    body = int(model.site_bodyid[site])
    own = part_of(model, body)
    seen = [g for g in range(model.ngeom) if visible(model, g)]
    solids = tuple(g for g in seen if model.geom_bodyid[g] not in own and model.geom_type[g] in (*SOLID_TYPES, HFIELD))
    # The range finder excludes the site's body; if that is the world, it would exclude all walls.
    native = body != 0 and all(model.geom_bodyid[g] == body for g in seen if model.geom_bodyid[g] in own)
    return _Ray(site, int(model.sensor_adr[sensor]), solids, native)


def _unusable(model: mujoco.MjModel, sensor: int, declaration: RangeDeclaration) -> str | None:
    if model.sensor_objtype[sensor] != mujoco.mjtObj.mjOBJ_SITE:
        return "must be attached to a site"
    if model.sensor_intprm[sensor, 0] != DISTANCE_ONLY:
        return "must report the distance only; remove its `data` attribute"
    if 0 < model.sensor_cutoff[sensor] <= declaration.high:
        return f"has a cutoff, which hides what lies beyond max {declaration.high:g}; remove it"
    if model.sensor_delay[sensor] > 0 or model.sensor_interval[sensor].any():
        return "has a delay or an interval, which are not supported; remove them"
    return None
