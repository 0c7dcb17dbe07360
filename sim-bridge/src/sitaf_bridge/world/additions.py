"""Additions to the MJCF before compilation: robots, spawned solids, user data of devices."""

from collections.abc import Mapping
from dataclasses import dataclass

import mujoco
import numpy as np

from sitaf_bridge.world.description.robot import Robot
from sitaf_bridge.world.robots.fitting import FLOOR, add_drives
from sitaf_bridge.world.robots.model import RobotModel

SHAPES = {
    "box": (mujoco.mjtGeom.mjGEOM_BOX, 3),
    "sphere": (mujoco.mjtGeom.mjGEOM_SPHERE, 1),
    "cylinder": (mujoco.mjtGeom.mjGEOM_CYLINDER, 2),
    "capsule": (mujoco.mjtGeom.mjGEOM_CAPSULE, 2),
}
# Robots collide with the world but not with themselves, because links of URDF collections overlap.
ROBOT_CONTYPE = 2
# Of a world that consists of a URDF.
TIMESTEP_S = 0.002


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
        spec.assets = _merged(assets, additions.robots)
    for model in additions.robots:
        _attach(spec, model)
    for entity in additions.entities:
        _spawn(spec, entity)


def _merged(assets: Mapping[str, bytes], robots: tuple[RobotModel, ...]) -> dict[str, bytes]:
    merged = dict(assets)
    for model in robots:
        for name, content in model.assets.items():
            if merged.setdefault(name, content) != content:
                message = f"has a file {name!r} that differs from another file of this name; rename one"
                raise ValueError(f"robots.{model.robot.name} {message}")
    return merged


def _attach(spec: mujoco.MjSpec, model: RobotModel) -> None:
    robot = model.robot
    if not robot.name:
        _complete(spec, model)
        return
    child = mujoco.MjSpec.from_string(model.text, include=dict(model.included), assets=dict(model.assets))
    if "<robot" in model.text:
        _prepare_urdf(child)
    _add_sites(child, robot)
    frame = spec.worldbody.add_frame(pos=robot.pos, quat=quaternion(robot.rpy))
    root = child.worldbody.first_body()
    if root is None:
        raise ValueError(f"robots.{robot.name}: the model has no body")
    name = root.name
    if robot.package:
        body = frame.attach_body(root, robot.prefix, "")
    else:
        # With everything that belongs to the model: actuators, sensors, keyframes, all its bodies.
        spec.attach(child, prefix=robot.prefix, frame=frame)
        body = spec.body(robot.prefix + name)
    if robot.base == "free":
        body.add_freejoint(name=f"{robot.prefix}base")
    if model.urdf:
        add_drives(spec, model, robot.prefix)


def _complete(spec: mujoco.MjSpec, model: RobotModel) -> None:
    """Make a world of a URDF: a floor, a light, and what the description of the robot says."""
    robot = model.robot
    spec.assets = dict(model.assets)
    spec.option.timestep = TIMESTEP_S
    spec.option.integrator = mujoco.mjtIntegrator.mjINT_IMPLICITFAST
    _prepare_urdf(spec)
    _add_sites(spec, robot)
    root = spec.worldbody.first_body()
    if root is None:
        raise ValueError("the robot has no link")
    if any(robot.pos) or any(robot.rpy):
        root.pos, root.quat = robot.pos, quaternion(robot.rpy)
    if robot.base == "free":
        root.add_freejoint(name="base")
    spec.worldbody.add_geom(name=FLOOR, type=mujoco.mjtGeom.mjGEOM_PLANE, size=[0, 0, 0.05])
    spec.worldbody.add_light(name="light", pos=[0, 0, 3], dir=[0, 0, -1])
    add_drives(spec, model, "")


def _prepare_urdf(spec: mujoco.MjSpec) -> None:
    for geom in spec.geoms:
        geom.contype = ROBOT_CONTYPE
    if all(body.explicitinertial for body in spec.bodies if any(geom.meshname for geom in body.geoms)):
        # The inertia of a flat mesh cannot be computed from its volume, and is not needed.
        for mesh in spec.meshes:
            mesh.inertia = mujoco.mjtMeshInertia.mjMESH_INERTIA_SHELL


def _add_sites(spec: mujoco.MjSpec, robot: Robot) -> None:
    place = f"robots.{robot.name}.sites" if robot.name else "sites"
    for site in robot.sites:
        body = spec.body(site.body)
        if body is None:
            raise ValueError(f"{place}.{site.name}.body: the robot has no body {site.body!r}")
        body.add_site(name=site.name, pos=site.pos, quat=quaternion(site.rpy))


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
