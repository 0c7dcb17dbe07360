"""Rays, and points inside of geoms: what MuJoCo's range finders leave open.

MuJoCo's ray from a point inside a solid reports the far face, and nothing at all behind a plane.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import mujoco
import numpy as np
from numpy.typing import NDArray

from sitaf_bridge.world.geometry.mesh_inside import Mesh

Vector = NDArray[np.float64]

PLANE = int(mujoco.mjtGeom.mjGEOM_PLANE)
HFIELD = int(mujoco.mjtGeom.mjGEOM_HFIELD)
SPHERE = int(mujoco.mjtGeom.mjGEOM_SPHERE)
CAPSULE = int(mujoco.mjtGeom.mjGEOM_CAPSULE)
ELLIPSOID = int(mujoco.mjtGeom.mjGEOM_ELLIPSOID)
CYLINDER = int(mujoco.mjtGeom.mjGEOM_CYLINDER)
BOX = int(mujoco.mjtGeom.mjGEOM_BOX)
MESH = int(mujoco.mjtGeom.mjGEOM_MESH)
SOLID_TYPES = (PLANE, SPHERE, CAPSULE, ELLIPSOID, CYLINDER, BOX, MESH)
PARALLEL = 1e-12
# Metres. Nearer than this to a surface, rounding decides on which side a point lies: it counts as touching.
TOUCH = 1e-10


def visible(model: mujoco.MjModel, geom: int) -> bool:
    """Whether rays see a geom: as in MuJoCo, one whose own or whose material's alpha is 0 is not there."""
    material = model.geom_matid[geom]
    if material >= 0:
        return bool(model.mat_rgba[material, 3] != 0)
    return bool(model.geom_rgba[geom, 3] != 0)


def cast(model: mujoco.MjModel, data: mujoco.MjData, geom: int, origin: Vector, along: Vector) -> float:
    """The distance in metres along a unit vector to the surface of one geom, or -1 if the ray misses it."""
    kind = int(model.geom_type[geom])
    if kind == MESH:
        return mujoco.mj_rayMesh(model, data, geom, origin, along)
    if kind == HFIELD:
        return mujoco.mj_rayHfield(model, data, geom, origin, along)
    size = model.geom_size[geom]
    return mujoco.mju_rayGeom(data.geom_xpos[geom], data.geom_xmat[geom], size, origin, along, kind)


def clearance(model: mujoco.MjModel, data: mujoco.MjData, geom: int, origin: Vector, along: Vector) -> float | None:
    """Where the line through `origin` enters the geom, in metres along a unit vector; negative behind the origin.

    None if the line does not enter it at all. Where the entry lies ahead, this is the ray's distance to the bit.
    """
    ahead = cast(model, data, geom, origin, along)
    centre = data.geom_xpos[geom]
    if int(model.geom_type[geom]) == PLANE:
        return ahead if ahead >= 0 else _plane_clearance(model, data, geom, origin, along)
    back = float(np.linalg.norm(origin - centre)) + float(model.geom_rbound[geom]) + 1.0
    entry = cast(model, data, geom, origin - back * along, along)
    if entry < 0:
        return None
    entry -= back
    # The ray from far away knows which face it is, the ray from the origin knows the last bits.
    return ahead if ahead >= 0 and abs(ahead - entry) < 1e-6 else entry


def _plane_clearance(
    model: mujoco.MjModel, data: mujoco.MjData, geom: int, origin: Vector, along: Vector
) -> float | None:
    axes = data.geom_xmat[geom].reshape(3, 3)
    relative = origin - data.geom_xpos[geom]
    towards = float(along @ axes[:, 2])
    if towards > -PARALLEL:
        return None
    distance = float(-(relative @ axes[:, 2]) / towards)
    hit = relative + distance * along
    for axis in (0, 1):
        half = model.geom_size[geom, axis]
        if half > 0 and abs(float(hit @ axes[:, axis])) > half:
            return None
    return distance


@dataclass(frozen=True)
class _Group:
    """Pairs of the same geom type: rows of `pairs` are (index of the asker, site, geom)."""

    kind: int
    askers: NDArray[np.intp]
    sites: NDArray[np.intp]
    geoms: NDArray[np.intp]


class Surroundings:
    """Tells for each of several sites which of its solids it lies inside of, and which it touches.

    A plane is solid behind its front, within its rectangle where it has one; height fields have no inside.
    All pairs of one geom type are computed together: calls, not arithmetic, are what costs.
    """

    def __init__(self, model: mujoco.MjModel, sites: Sequence[int], solids: Sequence[Sequence[int]]) -> None:
        self._count = len(sites)
        self._groups: list[_Group] = []
        self._meshes: dict[int, Mesh] = {}
        for kind in SOLID_TYPES:
            pairs = [
                (asker, sites[asker], geom)
                for asker, geoms in enumerate(solids)
                for geom in geoms
                if model.geom_type[geom] == kind
            ]
            if pairs:
                columns = np.array(pairs, dtype=np.intp).T
                self._groups.append(_Group(kind, columns[0], columns[1], columns[2]))
            if kind == MESH:
                self._meshes = {geom: Mesh.of(model, int(model.geom_dataid[geom])) for _, _, geom in pairs}

    def __call__(
        self, model: mujoco.MjModel, data: mujoco.MjData
    ) -> tuple[NDArray[np.bool_], Sequence[tuple[int, int]]]:
        """For each site whether it is inside; and the pairs (site's index, geom) of those that touch."""
        inside = np.zeros(self._count, dtype=np.bool_)
        touching: list[tuple[int, int]] = []
        for group in self._groups:
            relative = data.site_xpos[group.sites] - data.geom_xpos[group.geoms]
            axes = data.geom_xmat[group.geoms].reshape(-1, 3, 3)
            # The transposed rotation, summed in the order of MuJoCo's own rays.
            local = (
                axes[:, 0, :] * relative[:, 0:1] + axes[:, 1, :] * relative[:, 1:2] + axes[:, 2, :] * relative[:, 2:3]
            )
            if group.kind == MESH:
                pairs = zip(group.geoms.tolist(), local, strict=True)
                depth = np.array([self._meshes[geom].depth(point) for geom, point in pairs])
            else:
                depth = _depth(group.kind, local, model.geom_size[group.geoms])
            inside[group.askers[depth > TOUCH]] = True
            near = np.abs(depth) <= TOUCH
            if near.any():
                touching += zip(group.askers[near].tolist(), group.geoms[near].tolist(), strict=True)
        return inside, touching


def _depth(kind: int, p: Vector, size: Vector) -> Vector:
    """How deep points in the frames of geoms lie inside, in metres, negative outside: p and size are (n, 3).

    Exact near the surface, where it matters, up to a factor for the ellipsoid; elsewhere only the sign counts.
    """
    if kind == PLANE:
        beside = np.abs(p[:, :2]) - size[:, :2]
        return np.where(((size[:, :2] > 0) & (beside > 0)).any(axis=1), -np.inf, -p[:, 2])
    if kind == SPHERE:
        return size[:, 0] - np.sqrt((p * p).sum(axis=1))
    if kind == BOX:
        return (size - np.abs(p)).min(axis=1)
    if kind == ELLIPSOID:
        return (1.0 - np.sqrt(((p / size) ** 2).sum(axis=1))) * size.min(axis=1)
    across = np.hypot(p[:, 0], p[:, 1])
    if kind == CYLINDER:
        return np.minimum(size[:, 0] - across, size[:, 1] - np.abs(p[:, 2]))
    beyond = np.maximum(np.abs(p[:, 2]) - size[:, 1], 0.0)
    return size[:, 0] - np.hypot(across, beyond)
