"""Robots from installed Python packages: a world refers to the package and does not copy its files."""

import importlib.metadata
import posixpath
import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from importlib.metadata import Distribution

from sitaf_bridge.errors import BadWorld, LimitReached, Problem
from sitaf_bridge.world.description.source import MAX_BYTES, unsafe_path
from sitaf_bridge.world.description.yaml_block import Block

# Collections of robot models. Only files in a package's own list of files are read.
PACKAGES = ("example-robot-data", "gymnasium-robotics", "robosuite")
ASSET_SUFFIXES = (".stl", ".obj", ".msh", ".png")
PACKAGE = re.compile(r"(?P<name>[a-z0-9-]+)==(?P<version>[0-9][0-9A-Za-z.]*)")
ASSET = re.compile(r'(?P<key>\bfile(?:name)?=)"(?P<path>[^"]+)"')
BASES = ("fixed", "free")
# For URDF: visuals often have formats that MuJoCo does not read, and links often overlap.
URDF_COMPILER = (
    '<mujoco><compiler discardvisual="true" fusestatic="false" strippath="false" balanceinertia="true"/></mujoco>'
)


@dataclass(frozen=True)
class RobotSite:
    """A site on a body of the robot, for a sensor: metres, and radians about fixed axes."""

    name: str
    body: str
    pos: tuple[float, float, float]
    rpy: tuple[float, float, float]


@dataclass(frozen=True)
class Robot:
    """A robot of a package and its pose; all its names get the prefix `NAME_`."""

    name: str
    package: str
    version: str
    model: str
    base: str
    pos: tuple[float, float, float]
    rpy: tuple[float, float, float]
    sites: tuple[RobotSite, ...]
    line: int


@dataclass(frozen=True)
class RobotModel:
    """The text of a robot's model, and its files by their names in the model."""

    robot: Robot
    text: str
    assets: Mapping[str, bytes] = field(repr=False)


def read_robot(name: str, block: Block) -> Robot | None:
    """Read the keys `package`, `model`, `base`, `pos`, `rpy`, `sites`."""
    package, model, base = block.text("package"), block.text("model"), block.optional_text("base", "fixed")
    zero = (0.0, 0.0, 0.0)
    pos, rpy = block.triple("pos", zero), block.triple("rpy", zero)
    sites = [_site(site, inner) for site, inner in block.named_blocks("sites")]
    block.finish()
    if package is None or model is None or base is None or pos is None or rpy is None:
        return None
    match = PACKAGE.fullmatch(package)
    reason = unsafe_path(model)
    if match is None or match["name"] not in PACKAGES:
        block.problem(f"{block.path}.package: must be NAME==VERSION with NAME of {', '.join(PACKAGES)}", "package")
    elif reason is not None:
        block.problem(f"{block.path}.model: the path {model!r} {reason}", "model")
    elif base not in BASES:
        block.problem(f"{block.path}.base: {base!r} is not one of {', '.join(BASES)}", "base")
    else:
        found = tuple(site for site in sites if site is not None)
        return Robot(name, match["name"], match["version"], model, base, pos, rpy, found, block.line)
    return None


def _site(name: str, block: Block) -> RobotSite | None:
    body = block.text("body")
    pos, rpy = block.triple("pos", (0.0, 0.0, 0.0)), block.triple("rpy", (0.0, 0.0, 0.0))
    block.finish()
    return None if body is None or pos is None or rpy is None else RobotSite(name, body, pos, rpy)


def load_robot(robot: Robot, shown: str) -> RobotModel:
    """Read a robot's files from its package. Raises BadWorld, LimitReached."""
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
