"""Proposes a world for the file of a robot, and copies the files that it needs."""

import re
from dataclasses import dataclass, field
from pathlib import Path

import mujoco

from sitaf_bridge.errors import BadWorld, Problem
from sitaf_bridge.world.description.model_format import format_of
from sitaf_bridge.world.description.robot import Robot
from sitaf_bridge.world.description.source import DESCRIPTION_SUFFIX, WorldSource
from sitaf_bridge.world.proposal.devices import Wheels, chains_of, device_lines, joints_of, wheels_of
from sitaf_bridge.world.proposal.robot_files import RobotFiles
from sitaf_bridge.world.robots.loading import SDF
from sitaf_bridge.world.robots.package_files import PackageFiles
from sitaf_bridge.world.robots.urdf import BadUrdf, prepare
from sitaf_bridge.world.robots.xacro_text import BadXacro, expand
from sitaf_bridge.world.world import World, load_world

# Links of a URDF that carry a sensor, by their names.
SENSOR_LINK = re.compile(r"imu|lidar|laser|base_scan|(^|_)ft(_|$)|force_torque|tool0|tcp", re.IGNORECASE)
MAX_SITES = 12
# So many legs or arms begin at the body of a robot that walks; one that stands on a table has fewer.
WALKING = 4


@dataclass(frozen=True)
class ProposedWorld:
    """The name of the description, the files including it, and the world that they compile to."""

    description: str
    files: dict[str, bytes] = field(repr=False)
    world: World = field(repr=False)


def propose(robot: Path) -> ProposedWorld:
    """Propose the world of a robot. Raises BadWorld, LimitReached."""
    found = RobotFiles(robot)
    kind = format_of(found.main, found[found.main])
    if kind == "sdf":
        raise BadWorld([Problem(str(robot), None, SDF)])
    name = re.sub(r"\W+", "_", robot.name.split(".")[0]) or "robot"
    description = name + DESCRIPTION_SUFFIX
    files = _mjcf_files(found) if kind == "mjcf" else _urdf_files(found, kind)
    head = [f"mjcf: {found.main}"]
    used = [p for p in found.packages if any(path.startswith(p + "/") for path in files)]
    if used:
        head.append("packages: {" + ", ".join(f"{p}: {found.packages[p]}" for p in used) + "}")
    first = load_world(WorldSource(description, {**files, description: "\n".join(head).encode()}))
    wheels = wheels_of(first.model)
    lines = [
        f"# Proposed for {robot.name}. Check the devices, and delete those that the component does not use.",
        *head,
    ]
    sites: dict[str, str] = {}
    if kind != "mjcf":
        free = wheels is not None or chains_of(first.model) >= WALKING
        lines.append(f"base: {'free' if free else 'fixed'}" + "  # fixed to the world, or free to move")
        sites = _sensor_links(first.model)
        if free:
            sites = {**sites, "base_pose": _root(first.model)}
        if sites:
            lines.append("# Where sensors are: the frames of links. Move them with pos and rpy.")
            lines += ["sites:", *(f"  {site}: {{body: {body}}}" for site, body in sites.items())]
    lines += _text(first.model, wheels, sites, _root(first.model) if "base_pose" in sites else None)
    files[description] = ("\n".join(lines) + "\n").encode()
    return ProposedWorld(description, files, load_world(WorldSource(description, files)))


def _text(model: mujoco.MjModel, wheels: Wheels | None, sites: dict[str, str], base: str | None) -> list[str]:
    lines: list[str] = []
    keys = [mujoco.mj_id2name(model, mujoco.mjtObj.mjOBJ_KEY, k) or "" for k in range(model.nkey)]
    named = [key for key in keys if re.fullmatch(r"\w+", key)]
    if named:
        lines.append(f"start: {'home' if 'home' in named else named[0]}  # keyframes: {', '.join(named)}")
    lines += ["", "# What a test may vary (TDSD), for example:"]
    joints = joints_of(model)
    if mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_GEOM, "floor") >= 0:
        lines.append("parameters:")
        lines.append('  Friction: {unit: "1", range: [0, 2], default: 1, bind: {set: geom.floor.friction.0}}')
    elif joints:
        lines.append("# parameters:")
        lines.append(f"#   Start: {{unit: rad, range: [-1, 1], default: 0, bind: {{set: joint.{joints[0]}.pos}}}}")
    devices = list(device_lines(model, wheels, sites))
    if devices:
        lines += ["", "devices:", *(f"  {device}" for device in devices)]
    last = _wheel_base(model, wheels) if wheels else base or _last_body(model)
    if last:
        lines += ["", "# What a test may observe, in addition to the devices.", "observations:"]
        lines += [f"  {axis}: {{entity: {last}, axis: {axis}}}" for axis in "xyz"]
    return lines


def _urdf_files(found: RobotFiles, kind: str) -> dict[str, bytes]:
    robot = Robot("", "", "", found.main, "fixed", (0, 0, 0), (0, 0, 0), (), 1, packages=found.packages)
    try:
        text = found[found.main]
        kept = {}
        if kind == "xacro":
            kept = found.texts()
            text = expand(found.main, PackageFiles(kept, found.packages), {})
        found.read.clear()
        prepare(robot, text, found.main, PackageFiles(found, found.packages))
    except BadXacro as error:
        raise BadWorld([Problem(found.main, None, str(error))]) from error
    except BadUrdf as error:
        raise BadWorld([Problem(found.main, line, message) for line, message in error.problems]) from error
    return {**kept, **{path: found[path] for path in {*found.read, found.main}}}


def _mjcf_files(found: RobotFiles) -> dict[str, bytes]:
    """All files next to the model, which `meshdir` and `include` make relative to it."""
    return {path: found[path] for path in found if not path.endswith(DESCRIPTION_SUFFIX)}


def _bodies(model: mujoco.MjModel) -> list[str]:
    return [mujoco.mj_id2name(model, mujoco.mjtObj.mjOBJ_BODY, b) or "" for b in range(1, model.nbody)]


def _root(model: mujoco.MjModel) -> str:
    return next((name for name in _bodies(model) if name), "")


def _wheel_base(model: mujoco.MjModel, wheels: Wheels) -> str:
    joint = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_JOINT, wheels.left)
    body = int(model.body_parentid[model.jnt_bodyid[joint]])
    return mujoco.mj_id2name(model, mujoco.mjtObj.mjOBJ_BODY, body) or ""


def _last_body(model: mujoco.MjModel) -> str:
    """The end of the longest chain, such as the tool of an arm."""
    depth = [0]
    best, deepest = "", -1
    for body in range(1, model.nbody):
        depth.append(depth[int(model.body_parentid[body])] + 1)
        name = mujoco.mj_id2name(model, mujoco.mjtObj.mjOBJ_BODY, body) or ""
        if depth[body] > deepest and re.fullmatch(r"[\w-]+", name):
            best, deepest = name, depth[body]
    return best


def _sensor_links(model: mujoco.MjModel) -> dict[str, str]:
    links = [name for name in _bodies(model) if re.fullmatch(r"\w+", name) and SENSOR_LINK.search(name)]
    return {f"{name}_site": name for name in links[:MAX_SITES]}
