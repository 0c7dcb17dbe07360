"""Reads and moves bodies."""

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass

import mujoco
import numpy as np

from sitaf_bridge.errors import InvalidRequest, LimitReached
from sitaf_bridge.world.additions import SHAPES, SpawnedEntity
from sitaf_bridge.world.parameters.settings import NoSuchSetting, name_to_id
from sitaf_bridge.world.world import World

BODY = mujoco.mjtObj.mjOBJ_BODY
MAX_ENTITIES = 256
NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_]{0,127}")


@dataclass(frozen=True)
class Motion:
    """Position in metres, quaternion w, x, y, z, and velocity of a body's origin in the frame of the world.

    Fields that are None are not changed.
    """

    pos: Sequence[float] | None = None
    quat: Sequence[float] | None = None
    linear: Sequence[float] | None = None
    angular: Sequence[float] | None = None


def find_body(model: mujoco.MjModel, name: str) -> int:
    """The id of a body. Raises InvalidRequest."""
    try:
        return name_to_id(model, BODY, "body", name)
    except NoSuchSetting as error:
        raise InvalidRequest(f"entity: {error}") from error


def motion_of(model: mujoco.MjModel, data: mujoco.MjData, name: str) -> Motion:
    """The pose and velocity of a body."""
    body = find_body(model, name)
    velocity = np.empty(6)
    mujoco.mj_objectVelocity(model, data, mujoco.mjtObj.mjOBJ_XBODY, body, velocity, 0)
    return Motion(data.xpos[body].tolist(), data.xquat[body].tolist(), velocity[3:].tolist(), velocity[:3].tolist())


def put_motion(model: mujoco.MjModel, data: mujoco.MjData, name: str, motion: Motion) -> None:
    """Move a mocap body or a body with a free joint. Raises InvalidRequest."""
    body = find_body(model, name)
    for what, part in (("position", motion.pos), ("linear", motion.linear), ("angular", motion.angular)):
        _check_finite(f"state.{what}", part)
    quat = None if motion.quat is None else unit(motion.quat, "state.orientation")
    mocap, joint = int(model.body_mocapid[body]), int(model.body_jntadr[body])
    if mocap >= 0:
        if motion.linear is not None or motion.angular is not None:
            raise InvalidRequest(f"state.twist: {name} is a mocap body, which has no velocity")
        if motion.pos is not None:
            data.mocap_pos[mocap] = motion.pos
        if quat is not None:
            data.mocap_quat[mocap] = quat
    elif joint >= 0 and model.jnt_type[joint] == mujoco.mjtJoint.mjJNT_FREE:
        at, speed = int(model.jnt_qposadr[joint]), int(model.jnt_dofadr[joint])
        if motion.pos is not None:
            data.qpos[at : at + 3] = motion.pos
        if quat is not None:
            data.qpos[at + 3 : at + 7] = quat
        if motion.linear is not None:
            data.qvel[speed : speed + 3] = motion.linear
        if motion.angular is not None:
            # MuJoCo stores the angular velocity of a free joint in the frame of the body.
            turn = np.empty(9)
            mujoco.mju_quat2Mat(turn, data.qpos[at + 3 : at + 7])
            data.qvel[speed + 3 : speed + 6] = turn.reshape(3, 3).T @ np.array(motion.angular)
    else:
        raise InvalidRequest(f"entity: {name} cannot be moved: it is not a mocap body and has no free joint")


def push(
    model: mujoco.MjModel, data: mujoco.MjData, name: str, force: Sequence[float], torque: Sequence[float]
) -> None:
    """Apply a wrench at a body's centre of mass until the next call. Raises InvalidRequest."""
    body = find_body(model, name)
    _check_finite("wrench.force", force)
    _check_finite("wrench.torque", torque)
    data.xfrc_applied[body] = (*force, *torque)


def carry_over(old_model: mujoco.MjModel, old: mujoco.MjData, model: mujoco.MjModel, data: mujoco.MjData) -> None:
    """Copy the state to the data of a new model that differs only by spawned bodies at its end."""
    data.time = old.time
    for what in ("qpos", "qvel", "qacc_warmstart", "act", "ctrl", "mocap_pos", "mocap_quat", "userdata"):
        new, before = getattr(data, what), getattr(old, what)
        shared = min(len(new), len(before))
        new[:shared] = before[:shared]
    for body in range(1, min(old_model.nbody, model.nbody)):
        data.xfrc_applied[body] = old.xfrc_applied[body]
    # Any spawned body may have been removed, which shifts those after it.
    for body in range(1, model.nbody):
        name = mujoco.mj_id2name(model, BODY, body)
        before = mujoco.mj_name2id(old_model, BODY, name) if name else -1
        if before >= 0 and before != body:
            motion = motion_of(old_model, old, name)
            data.xfrc_applied[body] = old.xfrc_applied[before]
            still = model.body_mocapid[body] >= 0
            put_motion(model, data, name, Motion(motion.pos, motion.quat) if still else motion)


def checked(entity: SpawnedEntity, world: World) -> SpawnedEntity:
    """Check an entity to spawn and normalize its quaternion. Raises InvalidRequest, LimitReached."""
    if not NAME.fullmatch(entity.name):
        raise InvalidRequest(f"entity: the name {entity.name!r} must be letters, digits and '_'")
    for kind in (BODY, mujoco.mjtObj.mjOBJ_GEOM, mujoco.mjtObj.mjOBJ_JOINT):
        if mujoco.mj_name2id(world.model, kind, entity.name) >= 0:
            raise InvalidRequest(f"entity: the name {entity.name} is already used")
    if len(world.entities) >= MAX_ENTITIES:
        raise LimitReached(f"{MAX_ENTITIES} entities are spawned, which is the limit; delete one first")
    sizes = SHAPES[entity.shape][1]
    if len(entity.size) != sizes or not all(0 < size < math.inf for size in entity.size):
        raise InvalidRequest(f"size_m: a {entity.shape} needs {sizes} positive numbers, not {list(entity.size)}")
    if not 0 <= entity.mass < math.inf:
        raise InvalidRequest(f"mass_kg: {entity.mass} must not be negative")
    if len(entity.rgba) != 4 or not all(0 <= part <= 1 for part in entity.rgba):
        raise InvalidRequest("rgba: must be four numbers from 0 to 1")
    _check_finite("pose.position", entity.pos)
    w, x, y, z = unit(entity.quat, "pose.orientation")
    return SpawnedEntity(entity.name, entity.shape, entity.size, entity.pos, (w, x, y, z), entity.mass, entity.rgba)


def unit(quaternion: Sequence[float], shown: str) -> list[float]:
    """Normalize a quaternion, whose length must be nearly 1. Raises InvalidRequest."""
    _check_finite(shown, quaternion)
    length = math.sqrt(sum(part * part for part in quaternion))
    if abs(length - 1) > 1e-3:
        raise InvalidRequest(f"{shown}: the quaternion's length is {length:g}, not 1")
    return [part / length for part in quaternion]


def _check_finite(shown: str, numbers: Sequence[float] | None) -> None:
    if numbers is not None and not all(math.isfinite(number) for number in numbers):
        raise InvalidRequest(f"{shown}: {list(numbers)} contains a number that is not finite")
