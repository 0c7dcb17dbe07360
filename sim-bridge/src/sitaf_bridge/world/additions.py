"""Additions to the MJCF before compilation: robots of packages, spawned solids, user data of devices."""

from collections.abc import Mapping
from dataclasses import dataclass

import mujoco
import numpy as np

from sitaf_bridge.world.description.robot import RobotModel

SHAPES = {
    "box": (mujoco.mjtGeom.mjGEOM_BOX, 3),
    "sphere": (mujoco.mjtGeom.mjGEOM_SPHERE, 1),
    "cylinder": (mujoco.mjtGeom.mjGEOM_CYLINDER, 2),
    "capsule": (mujoco.mjtGeom.mjGEOM_CAPSULE, 2),
}
# Robots collide with the world but not with themselves, because links of URDF collections overlap.
ROBOT_CONTYPE = 2


@dataclass(frozen=True)
class SpawnedEntity:
    """A solid in metres and kilograms with a unit quaternion w, x, y, z. Without a mass it is a mocap body."""

    name: str
    shape: str
    size: tuple[float, ...]
    pos: tuple[float, float, float]
    quat: tuple[float, float, float, float]
    mass: float
    rgba: tuple[float, float, float, float]


@dataclass(frozen=True)
class Additions:
    """`userdata` is the number of device values; `image` the maximum width and height of a camera."""

    userdata: int = 0
    image: tuple[int, int] = (0, 0)
    robots: tuple[RobotModel, ...] = ()
    entities: tuple[SpawnedEntity, ...] = ()


def add(spec: mujoco.MjSpec, additions: Additions, assets: Mapping[str, bytes]) -> None:
    """Apply the additions to a parsed MJCF. Raises ValueError with MuJoCo's message."""
    spec.nuserdata = max(spec.nuserdata, 0) + additions.userdata
    if additions.image != (0, 0):
        visual = spec.visual
        # With software rendering, multisampling and shadows cost many times as much as the image.
        visual.quality.shadowsize = 0
        visual.quality.offsamples = 0
        visual.global_.offwidth = max(visual.global_.offwidth, additions.image[0])
        visual.global_.offheight = max(visual.global_.offheight, additions.image[1])
    if additions.robots:
        spec.assets = {**assets, **{k: v for robot in additions.robots for k, v in robot.assets.items()}}
    for model in additions.robots:
        _attach(spec, model)
    for entity in additions.entities:
        _spawn(spec, entity)


def _attach(spec: mujoco.MjSpec, model: RobotModel) -> None:
    robot = model.robot
    child = mujoco.MjSpec.from_string(model.text, assets=dict(model.assets))
    if "<robot" in model.text:
        for geom in child.geoms:
            geom.contype = ROBOT_CONTYPE
    for site in robot.sites:
        body = child.body(site.body)
        if body is None:
            raise ValueError(f"robots.{robot.name}.sites.{site.name}.body: the robot has no body {site.body!r}")
        body.add_site(name=site.name, pos=site.pos, quat=quaternion(site.rpy))
    frame = spec.worldbody.add_frame(pos=robot.pos, quat=quaternion(robot.rpy))
    root = child.worldbody.first_body()
    if root is None:
        raise ValueError(f"robots.{robot.name}.model has no body")
    body = frame.attach_body(root, f"{robot.name}_", "")
    if robot.base == "free":
        body.add_freejoint(name=f"{robot.name}_base")


def _spawn(spec: mujoco.MjSpec, entity: SpawnedEntity) -> None:
    mocap = entity.mass == 0
    body = spec.worldbody.add_body(name=entity.name, pos=entity.pos, quat=entity.quat, mocap=mocap)
    kind, _ = SHAPES[entity.shape]
    size = np.zeros(3)
    size[: len(entity.size)] = entity.size
    geom = body.add_geom(name=entity.name, type=kind, size=size, rgba=entity.rgba)
    if not mocap:
        body.add_freejoint(name=entity.name)
        geom.mass = entity.mass


def quaternion(rpy: tuple[float, float, float]) -> list[float]:
    """The unit quaternion w, x, y, z of rotations in radians about the fixed axes x, y, z, in this order (REP-103)."""
    result = np.empty(4)
    mujoco.mju_euler2Quat(result, np.array(rpy), "XYZ")
    return result.tolist()
