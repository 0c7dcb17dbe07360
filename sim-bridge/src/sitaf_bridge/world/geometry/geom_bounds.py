"""Bounding volumes of geoms, which MuJoCo computes during compilation only."""

import mujoco
import numpy as np
from numpy.typing import NDArray


def refit(model: mujoco.MjModel, geom: int) -> None:
    """Recompute the bounds of a primitive geom and the bounding tree of its body after a change of size."""
    half = _half_extents(model, geom)
    model.geom_aabb[geom] = (0.0, 0.0, 0.0, *half)
    model.geom_rbound[geom] = _radius(model, geom)
    body = int(model.geom_bodyid[geom])
    first = int(model.body_bvhadr[body])
    if first < 0:
        return
    to_body = _rotation(model.body_iquat[body]).T
    # Children follow their parent, so iterate backwards.
    for node in range(first + int(model.body_bvhnum[body]) - 1, first - 1, -1):
        leaf = int(model.bvh_nodeid[node])
        if leaf >= 0:
            turn = to_body @ _rotation(model.geom_quat[leaf])
            offset = to_body @ (model.geom_pos[leaf] - model.body_ipos[body])
            centre = offset + turn @ model.geom_aabb[leaf, :3]
            reach = np.abs(turn) @ model.geom_aabb[leaf, 3:]
            model.bvh_aabb[node] = np.concatenate([centre, reach])
        else:
            boxes = [model.bvh_aabb[first + int(child)] for child in model.bvh_child[node] if child >= 0]
            low = np.min([box[:3] - box[3:] for box in boxes], axis=0)
            high = np.max([box[:3] + box[3:] for box in boxes], axis=0)
            model.bvh_aabb[node] = np.concatenate([(low + high) / 2, (high - low) / 2])


def _half_extents(model: mujoco.MjModel, geom: int) -> tuple[float, float, float]:
    a, b, c = model.geom_size[geom].tolist()
    kind = model.geom_type[geom]
    if kind == mujoco.mjtGeom.mjGEOM_SPHERE:
        return a, a, a
    if kind == mujoco.mjtGeom.mjGEOM_CAPSULE:
        return a, a, a + b
    if kind == mujoco.mjtGeom.mjGEOM_CYLINDER:
        return a, a, b
    return a, b, c


def _radius(model: mujoco.MjModel, geom: int) -> float:
    """The radius of the bounding sphere around the geom's centre."""
    a, b, c = model.geom_size[geom].tolist()
    kind = model.geom_type[geom]
    if kind == mujoco.mjtGeom.mjGEOM_SPHERE:
        return a
    if kind == mujoco.mjtGeom.mjGEOM_CAPSULE:
        return a + b
    if kind == mujoco.mjtGeom.mjGEOM_CYLINDER:
        return float(np.hypot(a, b))
    return max(a, b, c) if kind == mujoco.mjtGeom.mjGEOM_ELLIPSOID else float(np.sqrt(a * a + b * b + c * c))


def _rotation(quaternion: NDArray[np.float64]) -> NDArray[np.float64]:
    matrix = np.empty(9)
    mujoco.mju_quat2Mat(matrix, quaternion)
    return matrix.reshape(3, 3)
