"""Loads the files of a robot: from the files of the world, or from an installed package."""

import importlib.metadata
import posixpath
import re
from collections.abc import Mapping
from importlib.metadata import Distribution

from sitaf_bridge.errors import BadWorld, LimitReached, Problem
from sitaf_bridge.world.description.mjcf_guard import check_mjcf
from sitaf_bridge.world.description.model_format import format_of
from sitaf_bridge.world.description.robot import Robot
from sitaf_bridge.world.description.source import MAX_BYTES
from sitaf_bridge.world.robots.model import RobotModel
from sitaf_bridge.world.robots.package_files import PackageFiles
from sitaf_bridge.world.robots.urdf import BadUrdf, prepare
from sitaf_bridge.world.robots.xacro_text import BadXacro, expand

ASSET_SUFFIXES = (".stl", ".obj", ".msh", ".png")
ASSET = re.compile(r'(?P<key>\bfile(?:name)?=)"(?P<path>[^"]+)"')
# For the robots of packages: visuals often have formats that MuJoCo does not read, and links often overlap.
URDF_COMPILER = (
    '<mujoco><compiler discardvisual="true" fusestatic="false" strippath="false" balanceinertia="true"/></mujoco>'
)
SDF = "SDF is not supported; MuJoCo reads MJCF and URDF. Export the model as URDF, or convert it to MJCF"


def load_robot(robot: Robot, files: Mapping[str, bytes], folder: str, shown: str) -> RobotModel:
    """Read a robot's files. Raises BadWorld, LimitReached.

    `files` are keyed relative to the `folder` of the world description `shown`.
    """
    return _of_package(robot, shown) if robot.package else _of_world(robot, files, folder, shown)


def _of_world(robot: Robot, files: Mapping[str, bytes], folder: str, shown: str) -> RobotModel:
    key = f"robots.{robot.name}.file" if robot.name else "mjcf"
    if robot.model not in files:
        message = f"{key}: {robot.model!r} is not among the files next to {shown}"
        raise BadWorld([Problem(shown, robot.line, message)])
    text, kind = files[robot.model], format_of(robot.model, files[robot.model])
    if kind == "sdf":
        raise BadWorld([Problem(folder + robot.model, None, SDF)])
    if kind == "mjcf":
        return _mjcf(robot, files, folder, shown)
    packages = PackageFiles(files, robot.packages)
    try:
        if kind == "xacro":
            text = expand(robot.model, packages, robot.xacro_args)
        elif robot.xacro_args:
            message = f"xacro_args of {robot.model!r}: the file is not xacro; remove the arguments"
            raise BadWorld([Problem(shown, robot.line, message)])
        prepared = prepare(robot, text, robot.model, packages)
    except BadXacro as error:
        raise BadWorld([Problem(folder + robot.model, None, str(error))]) from error
    except BadUrdf as error:
        raise BadWorld([Problem(folder + robot.model, line, message) for line, message in error.problems]) from error
    return RobotModel(robot, prepared.text, prepared.assets, urdf=True, drives=prepared.drives)


def _mjcf(robot: Robot, files: Mapping[str, bytes], folder: str, shown: str) -> RobotModel:
    """MJCF is used unchanged; its own folder holds its assets and includes."""
    wrong = [key for key in ("actuators", "xacro_args", "packages") if getattr(robot, key)]
    if wrong:
        message = f"robots.{robot.name}.{wrong[0]} is for URDF, but {robot.model!r} is MJCF; remove it"
        raise BadWorld([Problem(shown, robot.line, message)])
    check_mjcf(robot.model, files, folder)
    own = posixpath.dirname(robot.model)
    inside = {posixpath.relpath(path, own): c for path, c in files.items() if not own or path.startswith(own + "/")}
    included = {path: content for path, content in inside.items() if path.lower().endswith(".xml")}
    assets = {path: content for path, content in inside.items() if path not in included}
    return RobotModel(robot, files[robot.model].decode("utf-8"), assets, included)


def _of_package(robot: Robot, shown: str) -> RobotModel:
    where = f"robots.{robot.name}"
    try:
        distribution = importlib.metadata.distribution(robot.package)
    except importlib.metadata.PackageNotFoundError:
        distribution = None
    if distribution is None or distribution.version != robot.version:
        there = "it is not installed" if distribution is None else f"version {distribution.version} is installed"
        message = (
            f"{where}.package: this machine needs {robot.package}=={robot.version}, but {there}; install it with "
            'pip install "sitaf-bridge[robots]"'
        )
        raise BadWorld([Problem(shown, robot.line, message)])
    files = {str(path): path for path in distribution.files or ()}
    if robot.model not in files:
        message = f"{where}.model: the package {robot.package} has no file {robot.model!r}"
        raise BadWorld([Problem(shown, robot.line, message)])
    text = _content(distribution, robot.model).decode("utf-8")
    text, assets = _with_assets(robot, text, distribution, files)
    root = re.search(r"<robot\b[^>]*>", text)
    if root is not None:
        text = text[: root.end()] + URDF_COMPILER + text[root.end() :]
    return RobotModel(robot, text, assets)


def _with_assets(
    robot: Robot, text: str, distribution: Distribution, files: Mapping[str, object]
) -> tuple[str, dict[str, bytes]]:
    """Rename the assets in the text, so that files of two robots cannot be confused."""
    folder = posixpath.dirname(robot.model)
    keys: dict[str, str] = {}
    assets: dict[str, bytes] = {}

    def renamed(match: re.Match[str]) -> str:
        path = match["path"]
        if path not in keys:
            inside = _inside(path, folder, files)
            if inside is None:
                return match[0]
            keys[path] = f"{robot.name}-{len(keys)}{posixpath.splitext(path)[1].lower()}"
            assets[keys[path]] = _content(distribution, inside)
            if sum(len(content) for content in assets.values()) > MAX_BYTES:
                raise LimitReached(f"robots.{robot.name}: its files exceed {MAX_BYTES} bytes")
        return f'{match["key"]}"{keys[path]}"'

    return ASSET.sub(renamed, text), assets


def _inside(path: str, folder: str, files: Mapping[str, object]) -> str | None:
    """The file of the package that a model refers to, if any."""
    if not path.lower().endswith(ASSET_SUFFIXES):
        return None
    if path.startswith("package://"):
        tail = "/" + path.removeprefix("package://")
        return next((name for name in files if name.endswith(tail)), None)
    name = posixpath.normpath(posixpath.join(folder, path))
    return name if name in files else None


def _content(distribution: Distribution, name: str) -> bytes:
    with open(str(distribution.locate_file(name)), "rb") as file:
        return file.read()
