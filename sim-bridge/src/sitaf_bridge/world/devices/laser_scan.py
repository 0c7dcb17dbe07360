"""Kind `laser_scan`: rays in the plane of a site, after sensor_msgs/LaserScan and REP-117."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import mujoco
import numpy as np
from numpy.typing import NDArray

from sitaf_bridge.world.description.yaml_block import Block, Problems
from sitaf_bridge.world.devices.binding import find, find_all, part_of
from sitaf_bridge.world.devices.kind import DeviceDeclaration, DeviceKind, Reading
from sitaf_bridge.world.devices.range import within
from sitaf_bridge.world.geometry.solids import HFIELD, SOLID_TYPES, Surroundings, cast, visible

MAX_RAYS = 4096


@dataclass(frozen=True)
class ScanDeclaration(DeviceDeclaration):
    """Angles in radians, counterclockwise from the site's x axis, both inclusive; ranges in metres."""

    site: str
    first: float
    last: float
    rays: int
    low: float
    high: float

    @property
    def increment(self) -> float:
        """The angle between two rays."""
        return (self.last - self.first) / (self.rays - 1)


@dataclass(frozen=True)
class _Scanner:
    site: int
    body: int
    # Of each geom, whether it is fixed to the scanner; the last entry is for -1, no geom.
    own: NDArray[np.bool_]
    solids: tuple[int, ...]
    surroundings: Surroundings
    # Unit vectors in the frame of the site: shape (rays, 3).
    rays: NDArray[np.float64]


class LaserScanKind(DeviceKind):
    """Kind `laser_scan`."""

    name = "laser_scan"

    def declare(self, name: str, block: Block) -> ScanDeclaration | None:
        """Keys `site`, `angles`, `rays`, `min`, `max`."""
        site, angles, rays = block.text("site"), block.numbers("angles"), block.number("rays")
        low, high = block.number("min"), block.number("max")
        if site is None or angles is None or rays is None or low is None or high is None:
            return None
        if not 0 <= low < high:
            block.problem(f"{block.path}: min {low:g} and max {high:g} must be 0 <= min < max")
        elif not (2 <= rays <= MAX_RAYS and rays == int(rays)):
            block.problem(f"{block.path}.rays: {rays:g} must be a whole number from 2 to {MAX_RAYS}", "rays")
        elif not 0 < angles[1] - angles[0] <= 2 * math.pi:
            block.problem(f"{block.path}.angles: must be [first, last] in radians, within one turn", "angles")
        else:
            return ScanDeclaration(name, self.name, block.line, site, *angles, int(rays), low, high)
        return None

    def bind(self, model: mujoco.MjModel, declarations: Sequence[DeviceDeclaration], problems: Problems) -> "ScanBank":
        """Find the sites."""
        return ScanBank(find_all(declarations, problems, lambda d: _scanner(model, d)))

    def fields(self, declaration: DeviceDeclaration) -> tuple[str, ...]:
        """One range per ray."""
        assert isinstance(declaration, ScanDeclaration)  # noqa: S101
        return tuple(f"ranges.{ray}" for ray in range(declaration.rays))

    def limited(self, declaration: DeviceDeclaration, values: tuple[float, ...]) -> tuple[float, ...]:
        """Apply the range limits as in REP-117."""
        assert isinstance(declaration, ScanDeclaration)  # noqa: S101
        return tuple(within(value, declaration.low, declaration.high) for value in values)


def _scanner(model: mujoco.MjModel, declaration: DeviceDeclaration) -> _Scanner:
    assert isinstance(declaration, ScanDeclaration)  # noqa: S101
    site = find(model, "site", declaration.site)
    body = int(model.site_bodyid[site])
    own = part_of(model, body)
    solids = tuple(
        g
        for g in range(model.ngeom)
        if visible(model, g) and model.geom_bodyid[g] not in own and model.geom_type[g] in (*SOLID_TYPES, HFIELD)
    )
    angles = np.linspace(declaration.first, declaration.last, declaration.rays)
    rays = np.stack([np.cos(angles), np.sin(angles), np.zeros_like(angles)], axis=1)
    fixed = np.append(np.isin(model.geom_bodyid, list(own)), False)
    return _Scanner(site, body, fixed, solids, Surroundings(model, [site], [solids]), rays)


class ScanBank:
    """All laser scanners of a world."""

    def __init__(self, devices: Sequence[tuple[DeviceDeclaration, _Scanner]]) -> None:
        self._devices = tuple(devices)

    def read(self, model: mujoco.MjModel, data: mujoco.MjData) -> Sequence[Reading]:
        """The ranges at the current step."""
        return [Reading(d, _scan(model, data, d, s)) for d, s in self._devices]


def _scan(
    model: mujoco.MjModel, data: mujoco.MjData, declaration: DeviceDeclaration, scanner: _Scanner
) -> tuple[float, ...]:
    assert isinstance(declaration, ScanDeclaration)  # noqa: S101
    count = declaration.rays
    if scanner.surroundings(model, data)[0][0]:
        return (-math.inf,) * count
    origin = data.site_xpos[scanner.site]
    along = np.ascontiguousarray(scanner.rays @ data.site_xmat[scanner.site].reshape(3, 3).T)
    geoms = np.full(count, -1, np.int32)
    distances = np.empty(count)
    # Excluding no body (-1), a scanner that is fixed to the world sees walls that are fixed to the world, too.
    without = scanner.body if scanner.body else -1
    mujoco.mj_multiRay(
        model, data, origin, along.ravel(), None, 1, without, geoms, distances, None, count, declaration.high
    )
    # MuJoCo excludes one body; the other bodies of the scanner's rigid part are excluded here.
    for ray in np.flatnonzero(scanner.own[geoms]).tolist():
        hits = (cast(model, data, geom, origin, along[ray]) for geom in scanner.solids)
        distances[ray] = min((hit for hit in hits if hit >= 0), default=-1.0)
    ranges = np.where(distances < declaration.low, -math.inf, distances + 0.0)
    ranges[(distances < 0) | (distances > declaration.high)] = math.inf
    return tuple(ranges.tolist())
