"""Rays and inside tests for geoms, which MuJoCo's range finders do not cover.

A MuJoCo ray that starts inside a solid reports the far face, and nothing behind a plane.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

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
# Metres. Within this distance of a surface, rounding determines the side, so the point counts as touching.
TOUCH = 1e-10


def visible(model: mujoco.MjModel, geom: int) -> bool:
    """Whether rays hit a geom: like in MuJoCo, geoms whose own or whose material's alpha is 0 are ignored."""
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
    """The distance in metres along a unit vector to where the line through `origin` enters the geom; may be negative.

    None if the line does not enter it. If the entry is ahead, the value is bit-identical to the ray's distance.
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
    # A ray from far away finds the right face, a ray from the origin gives the exact distance.
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
    """Pairs of the same geom type: index of the site in the request, site, geom; and their indices among all pairs."""

    kind: int
    pairs: slice
    askers: NDArray[np.intp]
    sites: NDArray[np.intp]
    geoms: NDArray[np.intp]


class Surroundings:
    """Computes for several sites which solids they are inside of and which they touch.

    A plane is solid behind its front, within its rectangle if it has one; height fields have no inside. All pairs of
    one geom type are computed together, because the number of calls dominates the cost.
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
                first = sum(group.geoms.size for group in self._groups)
                place = slice(first, first + len(pairs))
                self._groups.append(_Group(kind, place, columns[0], columns[1], columns[2]))
            if kind == MESH:
                self._meshes = {geom: Mesh.of(model, int(model.geom_dataid[geom])) for _, _, geom in pairs}

        empty = [np.zeros(0, np.intp)]
        self._sites = np.concatenate([group.sites for group in self._groups] or empty)
        self._geoms = np.concatenate([group.geoms for group in self._groups] or empty)
        self._planes = next((group.pairs for group in self._groups if group.kind == PLANE), None)
        self._plane_geoms = self._geoms[self._planes] if self._planes is not None else empty[0]
        self._model = model
        self._reach = self._reach_in(model)

    def __call__(
        self, model: mujoco.MjModel, data: mujoco.MjData
    ) -> tuple[NDArray[np.bool_], Sequence[tuple[int, int]]]:
        """Return for each site whether it is inside; and the pairs (site index, geom) that touch."""
        inside = np.zeros(self._count, dtype=np.bool_)
        touching: list[tuple[int, int]] = []
        if not self._groups:
            return inside, touching
        # A point outside of the bounding sphere is not inside the geom, which excludes most pairs at little cost.
        # `take` costs a third of array indexing.
        relative = data.site_xpos.take(self._sites, 0) - data.geom_xpos.take(self._geoms, 0)
        reach = self._reach if model is self._model else self._reach_in(model)
        near = np.einsum("ij,ij->i", relative, relative) <= reach
        if self._planes is not None:
            normals = data.geom_xmat.take(self._plane_geoms, 0)[:, 2::3]
            near[self._planes] = np.einsum("ij,ij->i", relative[self._planes], normals) <= 2 * TOUCH
        if not near.any():
            return inside, touching
        for group in self._groups:
            chosen = np.flatnonzero(near[group.pairs])
            if not chosen.size:
                continue
            geoms, askers = group.geoms[chosen], group.askers[chosen]
            local = to_local(data.geom_xmat[geoms], relative[group.pairs][chosen])
            if group.kind == MESH:
                pairs = zip(geoms.tolist(), local, strict=True)
                depth = np.array([self._meshes[geom].depth(point) for geom, point in pairs])
            else:
                depth = depth_in(group.kind, local, model.geom_size[geoms])
            inside[askers[depth > TOUCH]] = True
            touches = np.abs(depth) <= TOUCH
            if touches.any():
                touching += zip(askers[touches].tolist(), geoms[touches].tolist(), strict=True)
        return inside, touching

    def _reach_in(self, model: mujoco.MjModel) -> Vector:
        """The squared distance within which each site may touch its geom; edited models may have other sizes."""
        reach = model.geom_rbound.take(self._geoms) + TOUCH
        return reach * reach

    def many(self, model: mujoco.MjModel, batch: Any, count: int) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
        """The same for a `mujoco.batch.Batch`: which sites are inside, (count, sites); which simulations touch."""
        inside = np.zeros((count, self._count), np.bool_)
        touches = np.zeros(count, np.bool_)
        sites, geoms = batch.bind("site_xpos")[:count], batch.bind("geom_xpos")[:count]
        matrices = batch.bind("geom_xmat")[:count]
        for geom in np.unique(self._geoms).tolist():
            members = np.flatnonzero(self._geoms == geom)
            group = next(g for g in self._groups if g.pairs.start <= members[0] < g.pairs.stop)
            askers = group.askers[members - group.pairs.start]
            relative = sites[:, self._sites[members]] - geoms[:, geom, None]
            if group.kind == PLANE:
                near = (relative @ matrices[:, geom, 2::3, None])[..., 0] <= 2 * TOUCH
            else:
                reach = float(model.geom_rbound[geom]) + TOUCH
                near = np.einsum("ijk,ijk->ij", relative, relative) <= reach * reach
            cases, which = np.nonzero(near)
            if not cases.size:
                continue
            local = to_local(matrices[cases, geom], relative[cases, which])
            if group.kind == MESH:
                depth = np.array([self._meshes[geom].depth(point) for point in local])
            else:
                depth = depth_in(group.kind, local, np.broadcast_to(model.geom_size[geom], local.shape))
            inside[cases[depth > TOUCH], askers[which[depth > TOUCH]]] = True
            touches[cases[np.abs(depth) <= TOUCH]] = True
        return inside, touches


def to_local(matrices: Vector, relative: Vector) -> Vector:
    """Rotate vectors (n, 3) into the frames of n rotation matrices (n, 9), summed in the order of MuJoCo's rays."""
    axes = matrices.reshape(-1, 3, 3)
    return axes[:, 0, :] * relative[:, 0:1] + axes[:, 1, :] * relative[:, 1:2] + axes[:, 2, :] * relative[:, 2:3]


def depth_in(kind: int, p: Vector, size: Vector) -> Vector:
    """The depth of points inside geoms in metres, negative outside: p and size are (n, 3) in the geoms' frames.

    Exact near the surface, except for a factor for ellipsoids; elsewhere only the sign is meaningful.
    """
    if kind == PLANE:
        outside = np.abs(p[:, :2]) - size[:, :2]
        return np.where(((size[:, :2] > 0) & (outside > 0)).any(axis=1), -np.inf, -p[:, 2])
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
