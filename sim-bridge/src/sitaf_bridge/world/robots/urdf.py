"""Prepares URDF for MuJoCo: finds its meshes among the files of the world, and its joints that can be driven.

MuJoCo reads URDF itself. What belongs to ROS or Gazebo is removed, and visual shapes are left out, because they often
have formats that MuJoCo does not read; a robot without collision shapes keeps its visual ones.
"""

import posixpath
import xml.etree.ElementTree as ET
from collections.abc import Iterator
from dataclasses import dataclass, field
from xml.parsers import expat

from sitaf_bridge.world.description.mjcf_guard import MAX_DEPTH, MAX_ELEMENTS
from sitaf_bridge.world.description.mjcf_limits import beyond_limits
from sitaf_bridge.world.description.robot import Robot
from sitaf_bridge.world.robots.ascii_stl import as_binary
from sitaf_bridge.world.robots.model import Drive
from sitaf_bridge.world.robots.package_files import Missing, PackageFiles

MESHES = (".stl", ".obj", ".msh")
FOREIGN = ("gazebo", "transmission", "ros2_control", "sensor")
# Links often overlap, have no inertia, or have one that no body can have; frames without mass must not be merged.
COMPILER = {
    "discardvisual": "false",
    "fusestatic": "false",
    "strippath": "false",
    "balanceinertia": "true",
    "boundmass": "1e-4",
    "boundinertia": "1e-7",
}
MODES = ("position", "velocity", "effort")


class BadUrdf(Exception):
    """A URDF that cannot be used: all problems, each with a line if it is known."""

    def __init__(self, problems: list[tuple[int | None, str]]) -> None:
        self.problems = problems
        super().__init__("; ".join(message for _, message in problems))


@dataclass
class PreparedUrdf:
    """URDF for MuJoCo, its meshes by their names in it, and the actuators of its joints."""

    text: str
    assets: dict[str, bytes] = field(default_factory=dict)
    drives: tuple[Drive, ...] = ()


def prepare(robot: Robot, text: bytes, path: str, files: PackageFiles) -> PreparedUrdf:
    """Prepare the URDF at `path` in the files of the world. Raises BadUrdf with every problem."""
    root = _parsed(text)
    problems: list[tuple[int | None, str]] = []
    drives = tuple(_drives(root, robot, problems))
    meshes = _compiler(root)
    _remove(root, FOREIGN)
    if root.find("link/collision") is not None:
        for link in root.iter("link"):
            for visual in link.findall("visual"):
                link.remove(visual)
    else:
        _drop_unreadable_visuals(root)
    for element in root.iter():
        problems += [(None, message) for message in beyond_limits(element.tag, element.attrib)]
    prepared = PreparedUrdf("", drives=drives)
    base = posixpath.join(posixpath.dirname(path), meshes)
    _take_meshes(root, robot, base, files=files, prepared=prepared, problems=problems)
    if problems:
        raise BadUrdf(problems)
    prepared.text = ET.tostring(root, encoding="unicode")
    return prepared


def _parsed(text: bytes) -> ET.Element:
    counts = [0, 0, 0]
    parser = expat.ParserCreate("utf-8")

    def start(_tag: str, _attributes: dict[str, str]) -> None:
        counts[0] += 1
        counts[1] += 1
        counts[2] = max(counts[1], counts[2])

    def end(_tag: str) -> None:
        counts[1] -= 1

    def doctype(*_: object) -> None:
        line = parser.CurrentLineNumber
        raise BadUrdf([(line, "a document type (<!DOCTYPE ...>) is not allowed; remove it")])

    parser.StartElementHandler, parser.EndElementHandler, parser.StartDoctypeDeclHandler = start, end, doctype
    try:
        parser.Parse(text, True)
        if counts[0] > MAX_ELEMENTS or counts[2] > MAX_DEPTH:
            limit = f"the limits are {MAX_ELEMENTS} elements and {MAX_DEPTH} levels"
            raise BadUrdf([(None, f"has {counts[0]} elements in {counts[2]} levels; {limit}")])
        # Safe after this check: there is no document type, so nothing can be expanded.
        root = ET.fromstring(text)  # noqa: S314
    except expat.ExpatError as error:
        raise BadUrdf([(error.lineno, f"not well-formed XML: {expat.ErrorString(error.code)}")]) from error
    except (ET.ParseError, ValueError, LookupError) as error:
        raise BadUrdf([(None, f"not well-formed XML: {error}")]) from error
    if root.tag != "robot":
        raise BadUrdf([(None, f"the root element is <{root.tag}>; a URDF begins with <robot>")])
    return root


def _remove(root: ET.Element, tags: tuple[str, ...]) -> None:
    for child in list(root):
        if child.tag in tags:
            root.remove(child)


def _compiler(root: ET.Element) -> str:
    """Set MuJoCo's options for URDF; returns the folder of meshes that the file names for MuJoCo."""
    extension = root.find("mujoco")
    if extension is None:
        extension = ET.Element("mujoco")
        root.insert(0, extension)
    compiler = extension.find("compiler")
    if compiler is None:
        compiler = ET.SubElement(extension, "compiler")
    folder = compiler.attrib.pop("meshdir", "") or compiler.attrib.pop("assetdir", "")
    for key in ("meshdir", "assetdir", "texturedir"):
        compiler.attrib.pop(key, None)
    chosen = {key: value for key, value in compiler.attrib.items() if key not in ("discardvisual", "strippath")}
    compiler.attrib.update({**COMPILER, **chosen})
    return folder


def _drop_unreadable_visuals(root: ET.Element) -> None:
    for link in root.iter("link"):
        for visual in link.findall("visual"):
            mesh = visual.find("geometry/mesh")
            if mesh is not None and not mesh.get("filename", "").lower().endswith(MESHES):
                link.remove(visual)


def _take_meshes(
    root: ET.Element,
    robot: Robot,
    base: str,
    *,
    files: PackageFiles,
    prepared: PreparedUrdf,
    problems: list[tuple[int | None, str]],
) -> None:
    """Read the meshes, which are relative to the folder `base`; give each a name that no other robot has."""
    names: dict[str, str] = {}
    for mesh in root.iter("mesh"):
        reference = mesh.get("filename", "")
        if reference not in names:
            names[reference] = ""
            if not reference.lower().endswith(MESHES):
                advice = "MuJoCo reads STL, OBJ and MSH; convert the mesh of this collision shape"
                problems.append((None, f"mesh {reference!r}: {advice}"))
                continue
            try:
                content = files.find(reference, base)
            except Missing as error:
                problems.append((None, f"mesh {reference!r}: {error}"))
                continue
            suffix = posixpath.splitext(reference)[1].lower()
            names[reference] = f"{robot.name or 'robot'}-{len(names)}{suffix}"
            prepared.assets[names[reference]] = as_binary(content) if suffix == ".stl" else content
        mesh.set("filename", names[reference])


def _drives(root: ET.Element, robot: Robot, problems: list[tuple[int | None, str]]) -> Iterator[Drive]:
    """The joints that get an actuator: those that the world lists, else those that the URDF declares, else all."""
    joints = {
        joint.get("name", ""): joint
        for joint in root.findall("joint")
        if joint.get("type") in ("revolute", "continuous", "prismatic") and joint.find("mimic") is None
    }
    if isinstance(robot.actuators, dict):
        for name in robot.actuators:
            if name not in joints:
                known = ", ".join(joints) or "none"
                problems.append((None, f"actuators.{name}: the robot has no such joint to drive; joints: {known}"))
        modes = {name: mode for name, mode in robot.actuators.items() if name in joints}
    else:
        declared = {name: mode for name, mode in _declared(root) if name in joints}
        modes = declared or {name: _natural(joint, robot) for name, joint in joints.items()}
        if isinstance(robot.actuators, str):
            modes = {} if robot.actuators == "none" else dict.fromkeys(modes, robot.actuators)
    for name, mode in modes.items():
        limit = joints[name].find("limit")
        limits = {} if limit is None else limit.attrib
        low, high = _number(limits, "lower"), _number(limits, "upper")
        limited = joints[name].get("type") != "continuous" and low < high
        yield Drive(name, mode, limited, low, high, _number(limits, "effort"), _number(limits, "velocity"))


def _natural(joint: ET.Element, robot: Robot) -> str:
    return "velocity" if joint.get("type") == "continuous" and robot.base == "free" else "position"


def _declared(root: ET.Element) -> Iterator[tuple[str, str]]:
    for control in root.findall("ros2_control"):
        for joint in control.findall("joint"):
            commands = [c.get("name", "") for c in joint.findall("command_interface")]
            mode = next((mode for mode in MODES if mode in commands), None)
            if mode is not None:
                yield joint.get("name", ""), mode
    for transmission in root.findall("transmission"):
        for joint in transmission.findall("joint"):
            kind = " ".join((i.text or "").lower() for i in transmission.iter("hardwareInterface"))
            yield joint.get("name", ""), next((mode for mode in MODES if mode in kind), "position")


def _number(attributes: dict[str, str], key: str) -> float:
    try:
        return float(attributes.get(key, "0"))
    except ValueError:
        return 0.0
