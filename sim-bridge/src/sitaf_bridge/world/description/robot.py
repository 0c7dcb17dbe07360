"""Declarations of robots: of files next to the world, or of installed Python packages."""

import re
from collections.abc import Mapping
from dataclasses import dataclass, field

from sitaf_bridge.world.description.source import unsafe_path
from sitaf_bridge.world.description.yaml_block import Block

# Collections of robot models. Only files in a package's own list of files are read.
PACKAGES = ("example-robot-data", "gymnasium-robotics", "robosuite")
PACKAGE = re.compile(r"(?P<name>[a-z0-9-]+)==(?P<version>[0-9][0-9A-Za-z.]*)")
BASES = ("fixed", "free")
MODES = ("position", "velocity", "effort", "none")


@dataclass(frozen=True)
class RobotSite:
    """A site on a body of the robot, for a sensor: metres, and radians about fixed axes."""

    name: str
    body: str
    pos: tuple[float, float, float]
    rpy: tuple[float, float, float]


@dataclass(frozen=True)
class Robot:
    """A robot and its pose; all its names get the prefix `NAME_`, unless it is the whole model of the world.

    `package` is empty for a file of the world. `placed`: the world says where it is. `actuators` is a mode for all
    joints, or one for each driven joint; None leaves it to the URDF.
    """

    name: str
    package: str
    version: str
    model: str
    base: str
    pos: tuple[float, float, float]
    rpy: tuple[float, float, float]
    sites: tuple[RobotSite, ...]
    line: int
    placed: bool = True
    packages: Mapping[str, str] = field(default_factory=dict)
    xacro_args: Mapping[str, str] = field(default_factory=dict)
    actuators: str | Mapping[str, str] | None = None

    @property
    def prefix(self) -> str:
        """The prefix of its names."""
        return f"{self.name}_" if self.name else ""


def read_robot(name: str, block: Block) -> Robot | None:
    """Read a robot of a package (`package`, `model`) or of the world (`file`), and the keys of both."""
    if not block.has("package"):
        robot = read_file_robot(name, block, "file")
        block.finish()
        return robot
    package, model, base = block.text("package"), block.text("model"), block.optional_text("base", "fixed")
    zero = (0.0, 0.0, 0.0)
    pos, rpy = block.triple("pos", zero), block.triple("rpy", zero)
    sites = _sites(block)
    block.finish()
    if package is None or model is None or base is None or pos is None or rpy is None:
        return None
    match = PACKAGE.fullmatch(package)
    reason = unsafe_path(model)
    if match is None or match["name"] not in PACKAGES:
        block.problem(f"{block.path}.package: must be NAME==VERSION with NAME of {', '.join(PACKAGES)}", "package")
    elif reason is not None:
        block.problem(f"{block.path}.model: the path {model!r} {reason}", "model")
    elif _base(block, base):
        return Robot(name, match["name"], match["version"], model, base, pos, rpy, sites, block.line)
    return None


def read_file_robot(name: str, block: Block, key: str) -> Robot | None:
    """Read a robot whose file is at `key`."""
    model, base = block.text(key), block.optional_text("base", "fixed")
    zero = (0.0, 0.0, 0.0)
    placed = block.has("pos")
    pos, rpy = block.triple("pos", zero), block.triple("rpy", zero)
    sites = _sites(block)
    packages, arguments = block.named_texts("packages"), block.named_texts("xacro_args")
    actuators = _actuators(block)
    if model is None or base is None or pos is None or rpy is None or packages is None or arguments is None:
        return None
    reason = unsafe_path(model)
    if reason is not None:
        block.problem(f"{block.inner(key)}: the path {model!r} {reason}", key)
        return None
    for package, folder in packages.items():
        reason = unsafe_path(folder.rstrip("/")) if folder != "." else None
        if reason is not None:
            block.problem(f"{block.inner('packages')}.{package}: the path {folder!r} {reason}", "packages")
    if not _base(block, base):
        return None
    return Robot(name, "", "", model, base, pos, rpy, sites, block.line, placed, packages, arguments, actuators)


def _base(block: Block, base: str) -> bool:
    if base not in BASES:
        block.problem(f"{block.inner('base')}: {base!r} is not one of {', '.join(BASES)}", "base")
    return base in BASES


def _actuators(block: Block) -> str | dict[str, str] | None:
    """A mode for all joints, or a mapping from joints to modes."""
    if not block.has("actuators"):
        return block.optional_text("actuators", "") or None
    found = block.text_or_texts("actuators")
    modes = [found] if isinstance(found, str) else list((found or {}).values())
    for mode in modes:
        if mode not in MODES:
            block.problem(f"{block.inner('actuators')}: {mode!r} is not one of {', '.join(MODES)}", "actuators")
            return None
    if isinstance(found, dict):
        return {joint: mode for joint, mode in found.items() if mode != "none"}
    return found


def _sites(block: Block) -> tuple[RobotSite, ...]:
    sites = [_site(site, inner) for site, inner in block.named_blocks("sites")]
    return tuple(site for site in sites if site is not None)


def _site(name: str, block: Block) -> RobotSite | None:
    body = block.text("body")
    pos, rpy = block.triple("pos", (0.0, 0.0, 0.0)), block.triple("rpy", (0.0, 0.0, 0.0))
    block.finish()
    return None if body is None or pos is None or rpy is None else RobotSite(name, body, pos, rpy)
