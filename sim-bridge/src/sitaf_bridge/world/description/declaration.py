"""The world description (`NAME.world.yaml`): its parameters, devices and observations."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace

from sitaf_bridge.world.description.model_format import format_of
from sitaf_bridge.world.description.observation import Observation, read_observation
from sitaf_bridge.world.description.robot import Robot, read_file_robot, read_robot
from sitaf_bridge.world.description.source import WorldSource, unsafe_path
from sitaf_bridge.world.description.yaml_block import Block, Problems, parse
from sitaf_bridge.world.devices import KINDS, DeviceDeclaration

# Limits the memory for past readings of a device.
MAX_DELAY_S = 10.0
MAX_RATE_HZ = 100_000.0
# The `set` path of a parameter that selects a keyframe.
START = "start"


@dataclass(frozen=True)
class Gap:
    """A signed distance from the site along its z axis to the surface of the geom."""

    site: str
    geom: str


@dataclass(frozen=True)
class Bind:
    """The quantity at `path` that a parameter sets, directly or such that `gap` equals the parameter.

    The path `start` selects one of the keyframes `choices` by its index.
    """

    path: str
    gap: Gap | None
    line: int
    choices: tuple[str, ...] = ()


@dataclass(frozen=True)
class Parameter:
    """A parameter of tests. `low` and `high` are inclusive, in `unit`."""

    name: str
    unit: str
    low: float
    high: float
    default: float
    binds: tuple[Bind, ...]


@dataclass(frozen=True, eq=False)
class Description:
    """A well-formed world description; its names are not yet resolved in the MJCF.

    Descriptions with equal content are equal. `whole` is the robot if the model of the world is a URDF. `start` is the
    keyframe in which a session begins.
    """

    file: str
    mjcf: str
    parameters: Mapping[str, Parameter] = field(default_factory=dict)
    devices: Mapping[str, DeviceDeclaration] = field(default_factory=dict)
    observations: Mapping[str, Observation] = field(default_factory=dict)
    robots: Mapping[str, Robot] = field(default_factory=dict)
    whole: Robot | None = None
    start: str | None = None
    start_line: int = 0


def read_description(source: WorldSource) -> Description:
    """Parse the world description of a source. Raises BadWorld with every problem found."""
    problems = Problems(source.description)
    top = parse(source.files[source.description], problems)
    mjcf = _mjcf(top, source)
    whole = read_file_robot("", top, "mjcf") if mjcf is not None and _is_urdf(mjcf, source) else None
    start = top.text("start") if top.has("start") else top.optional_text("start", "")
    parameters = {name: _parameter(name, block) for name, block in top.named_blocks("parameters")}
    robots = {name: read_robot(name, block) for name, block in top.named_blocks("robots")}
    devices = {name: _device(name, block) for name, block in top.named_blocks("devices")}
    observations = {name: read_observation(name, block, devices) for name, block in top.named_blocks("observations")}
    top.finish()
    _check_shared_paths(parameters.values(), problems)
    problems.raise_if_any()
    return Description(
        file=source.description,
        mjcf=mjcf or "",
        parameters={name: p for name, p in parameters.items() if p},
        devices={name: replace(d, slot=len(devices) - index) for index, (name, d) in enumerate(devices.items()) if d},
        robots={name: r for name, r in robots.items() if r},
        observations={name: o for name, o in observations.items() if o},
        whole=whole,
        start=start or None,
        start_line=top.line_of("start"),
    )


def _is_urdf(mjcf: str, source: WorldSource) -> bool:
    content = source.files.get(source.folder + mjcf)
    return content is not None and format_of(mjcf, content) in ("urdf", "xacro")


def _mjcf(top: Block, source: WorldSource) -> str | None:
    name = top.text("mjcf")
    if name is None:
        return None
    reason = unsafe_path(name)
    if reason is not None:
        top.problem(f"mjcf: the path {name!r} {reason}", "mjcf")
    elif source.folder + name not in source.files:
        top.problem(f"mjcf: {name!r} is not among the files next to {source.description}", "mjcf")
    return name


def _parameter(name: str, block: Block) -> Parameter | None:
    unit = block.text("unit")
    bounds = block.numbers("range")
    default = block.number("default")
    binds = [_bind(bind) for bind in block.one_or_more("bind")]
    block.finish()
    if bounds is not None:
        low, high = bounds
        if low > high:
            block.problem(f"{block.path}.range: {low:g} is above {high:g}; write [lowest, highest]", "range")
        elif default is not None and not low <= default <= high:
            block.problem(f"{block.path}.default: {default:g} is outside the range [{low:g}, {high:g}]", "default")
    whole = tuple(bind for bind in binds if bind is not None)
    if bounds is not None:
        for bind in whole:
            if bind.path == START and bounds != (0, len(bind.choices) - 1):
                most = len(bind.choices) - 1
                block.problem(f"{block.path}.range: must be [0, {most}], the indices of `choices`", "range")
    if unit is None or bounds is None or default is None or len(whole) != len(binds):
        return None
    return Parameter(name, unit, bounds[0], bounds[1], default, whole)


def _bind(block: Block) -> Bind | None:
    path = block.text("set")
    names = block.texts("gap")
    choices = block.list_of_texts("choices") if path == START else ()
    block.finish()
    gap = None
    if path == START and names is not None:
        block.problem(f"{block.path}.gap: a gap cannot solve for a start state", "gap")
    if names is not None:
        site, geom = names
        if site.startswith("site.") and geom.startswith("geom."):
            gap = Gap(site.removeprefix("site."), geom.removeprefix("geom."))
        else:
            block.problem(f"{block.path}.gap must be [site.NAME, geom.NAME], not [{site}, {geom}]", "gap")
    return None if path is None else Bind(path, gap, block.line, tuple(choices))


def _device(name: str, block: Block) -> DeviceDeclaration | None:
    kind = block.text("kind")
    if kind is None:
        return None
    if kind not in KINDS:
        block.problem(f"{block.path}.kind: {kind!r} is not a device kind; known: {', '.join(KINDS)}", "kind")
        return None
    declaration = KINDS[kind].declare(name, block)
    if KINDS[kind].image:
        noise = delay = 0.0
    else:
        noise, delay = block.optional_number("noise", 0.0), block.optional_number("delay", 0.0)
    # How often it sends messages to a ROS 2 node; the test application reads it.
    rate = block.optional_number("rate_hz", 10.0)
    if rate is not None and not 0 < rate <= MAX_RATE_HZ:
        block.problem(f"{block.path}.rate_hz must be greater than 0 and at most {MAX_RATE_HZ:g}", "rate_hz")
        return None
    block.finish()
    if declaration is None or noise is None or delay is None or rate is None:
        return None
    if noise < 0 or not 0 <= delay <= MAX_DELAY_S:
        block.problem(f"{block.path}: noise must not be negative, and delay must be 0 to {MAX_DELAY_S:g} s")
        return None
    return replace(declaration, noise=noise, delay=delay)


def _check_shared_paths(parameters: Iterable[Parameter | None], problems: Problems) -> None:
    """Report quantities that two parameters set, because the second one would overwrite the first."""
    owners: dict[str, str] = {}
    for parameter in parameters:
        if parameter is None:
            continue
        for bind in parameter.binds:
            owner = owners.setdefault(bind.path, parameter.name)
            if owner != parameter.name or sum(b.path == bind.path for b in parameter.binds) > 1:
                problems.add(bind.line, f"parameters.{parameter.name}: {bind.path} is already set by {owner}")
