"""Guesses the devices of a robot from the names and kinds of its joints, sites and cameras."""

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass

import mujoco
import numpy as np

MAX_JOINTS = 60
HINGE_OR_SLIDE = (mujoco.mjtJoint.mjJNT_HINGE, mujoco.mjtJoint.mjJNT_SLIDE)


@dataclass(frozen=True)
class Wheels:
    """The driven wheels of a differential base: joints, radius and distance in metres."""

    left: str
    right: str
    radius: float
    track: float


def joints_of(model: mujoco.MjModel) -> list[str]:
    """The names of all hinges and slides."""
    return [
        name
        for joint in range(model.njnt)
        if mujoco.mjtJoint(int(model.jnt_type[joint])) in HINGE_OR_SLIDE
        and (name := mujoco.mj_id2name(model, mujoco.mjtObj.mjOBJ_JOINT, joint))
    ][:MAX_JOINTS]


def wheels_of(model: mujoco.MjModel) -> Wheels | None:
    """The pair of wheels of a base: unlimited joints whose names differ in left and right."""
    names = [name for name in joints_of(model) if not model.jnt_limited[_joint(model, name)]]
    wheels = [name for name in names if "wheel" in name.lower()] or names
    for left, right in (("left", "right"), ("_l_", "_r_"), ("Left", "Right"), ("l_", "r_"), ("_l", "_r")):
        for name in wheels:
            other = name.replace(left, right)
            if left in name and other in wheels and "caster" not in name.lower():
                return Wheels(name, other, _radius(model, name), _distance(model, name, other))
    return None


def chains_of(model: mujoco.MjModel) -> int:
    """The number of jointed chains that begin at the root of the first robot."""
    roots = [b for b in range(1, model.nbody) if model.body_parentid[b] == 0 and model.body_subtreemass[b] > 0]
    if not roots:
        return 0
    rigid = {b for b in range(1, model.nbody) if model.body_weldid[b] == model.body_weldid[roots[0]]}
    return sum(
        1
        for b in range(1, model.nbody)
        if b not in rigid and int(model.body_parentid[b]) in rigid | {0} and model.body_jntnum[b]
    )


def device_lines(model: mujoco.MjModel, wheels: Wheels | None, sites: dict[str, str]) -> Iterator[str]:
    """The entries of `devices`; `sites` are those that the world adds, by name, with their link."""
    named = _Names()
    driven: set[str] = set()
    if wheels is not None:
        radius, track = f"{wheels.radius:.4g}", f"{wheels.track:.4g}"
        actuators = {joint: actuator for actuator, joint in _actuators(model)}
        left, right = actuators.get(wheels.left), actuators.get(wheels.right)
        if left is not None and right is not None:
            keys = f"left: {left}, right: {right}, wheel_radius: {radius}, track: {track}"
            yield f"{named('base')}: {{kind: differential_drive, {keys}}}"
            driven = {wheels.left, wheels.right}
    for actuator, joint in _actuators(model):
        if joint not in driven:
            yield f"{named(_short(joint))}: {{kind: joint_motor, actuator: {_quoted(actuator)}}}"
    for joint in joints_of(model):
        yield f"{named(_short(joint) + '_encoder')}: {{kind: joint_encoder, joint: {_quoted(joint)}}}"
    for site in [*_names(model, mujoco.mjtObj.mjOBJ_SITE, model.nsite), *sites]:
        yield from _at_site(site, named)
    for sensor in range(model.nsensor):
        if mujoco.mjtSensor(int(model.sensor_type[sensor])) == mujoco.mjtSensor.mjSENS_RANGEFINDER:
            name = mujoco.mj_id2name(model, mujoco.mjtObj.mjOBJ_SENSOR, sensor)
            if name and model.sensor_cutoff[sensor] == 0:
                yield f"{named(name)}: {{kind: range, sensor: {_quoted(name)}, min: 0.02, max: 4}}"
    for camera in _names(model, mujoco.mjtObj.mjOBJ_CAMERA, model.ncam):
        yield f"{named(camera)}: {{kind: camera, camera: {_quoted(camera)}, width: 320, height: 240}}"


def _at_site(site: str, named: Callable[[str], str]) -> Iterator[str]:
    lower, shown = site.lower(), _quoted(site)
    if "imu" in lower or "gyro" in lower or "accel" in lower:
        yield f"{named(site)}: {{kind: imu, site: {shown}}}"
    elif re.search("lidar|laser|scan", lower):
        angles = "angles: [-3.14, 3.14], rays: 181, min: 0.1, max: 10"
        yield f"{named(site)}: {{kind: laser_scan, site: {shown}, {angles}}}"
    elif re.search("force|torque|(^|_)ft(_|$)", lower):
        yield f"{named(site)}: {{kind: force_torque, site: {shown}}}"
    elif re.search("attachment|tool|tcp|ee_|end_eff|grasp|base_pose|gps", lower):
        yield f"{named(site)}: {{kind: pose, site: {shown}}}"


def _actuators(model: mujoco.MjModel) -> Iterator[tuple[str, str]]:
    """The names of position, velocity and effort actuators, each with its joint."""
    for actuator in range(model.nu):
        joint = int(model.actuator_trnid[actuator, 0])
        if (
            mujoco.mjtTrn(int(model.actuator_trntype[actuator])) == mujoco.mjtTrn.mjTRN_JOINT
            and mujoco.mjtJoint(int(model.jnt_type[joint])) in HINGE_OR_SLIDE
            and mujoco.mjtGain(int(model.actuator_gaintype[actuator])) == mujoco.mjtGain.mjGAIN_FIXED
        ):
            name = mujoco.mj_id2name(model, mujoco.mjtObj.mjOBJ_ACTUATOR, actuator)
            driven = mujoco.mj_id2name(model, mujoco.mjtObj.mjOBJ_JOINT, joint)
            if name and driven:
                yield name, driven


def _names(model: mujoco.MjModel, kind: mujoco.mjtObj, count: int) -> list[str]:
    return [name for i in range(count) if (name := mujoco.mj_id2name(model, kind, i))]


def _joint(model: mujoco.MjModel, name: str) -> int:
    return int(mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_JOINT, name))


def _radius(model: mujoco.MjModel, joint: str) -> float:
    """Half of the largest extent across the wheel's axis."""
    body = int(model.jnt_bodyid[_joint(model, joint)])
    first, count = int(model.body_geomadr[body]), int(model.body_geomnum[body])
    halves = [np.sort(model.geom_aabb[g, 3:])[1] for g in range(first, first + count)]
    return float(max(halves, default=0.1))


def _distance(model: mujoco.MjModel, left: str, right: str) -> float:
    data = mujoco.MjData(model)
    mujoco.mj_kinematics(model, data)
    a, b = (data.xanchor[_joint(model, name)] for name in (left, right))
    return float(np.linalg.norm(a - b))


def _short(name: str) -> str:
    return re.sub(r"_?joint$|^joint_(?=\D)", "", name, flags=re.IGNORECASE) or name


def _quoted(name: str) -> str:
    """A name in YAML."""
    return name if re.fullmatch(r"[A-Za-z_][\w-]*", name) else "'" + name.replace("'", "''") + "'"


class _Names:
    """Gives out unique names of devices."""

    def __init__(self) -> None:
        self._taken: set[str] = set()

    def __call__(self, wanted: str) -> str:
        plain = re.sub(r"\W+", "_", wanted).strip("_") or "device"
        base = f"_{plain}" if plain[0].isdigit() else plain
        name, number = base, 2
        while name in self._taken:
            name, number = f"{base}_{number}", number + 1
        self._taken.add(name)
        return name
