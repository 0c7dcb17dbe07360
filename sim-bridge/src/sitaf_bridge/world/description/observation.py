"""The entries of `observations`: what a test may check after the call."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from sitaf_bridge.world.description.yaml_block import Block
from sitaf_bridge.world.devices import KINDS, DeviceDeclaration

LINES = ("x", "y", "z")
ANGLES = ("roll", "pitch", "yaw")
AXES = (*LINES, *ANGLES)
QUATERNION = ("x", "y", "z", "w")


@dataclass(frozen=True)
class Coordinate:
    """The position of a body along x, y, z in metres, or its rotation about them in radians (fixed axes, REP-103)."""

    entity: str
    axis: str


@dataclass(frozen=True)
class Velocity:
    """The velocity of a body's origin along a world axis in m/s, or its angular velocity about it in rad/s."""

    entity: str
    axis: str


@dataclass(frozen=True)
class Orientation:
    """One component of the unit quaternion of a body, with the sign for which w is not negative."""

    entity: str
    part: str


@dataclass(frozen=True)
class DeviceNumber:
    """A number in a device's reading, as the component sees it; `index` counts the fields of the device."""

    device: str
    index: int
    field: str


@dataclass(frozen=True)
class Touch:
    """1 while two geoms, or geoms of two bodies, touch, otherwise 0."""

    first: str
    second: str


@dataclass(frozen=True)
class Distance:
    """The distance between the origins of two bodies in metres."""

    body1: str
    body2: str


Sight = Coordinate | Velocity | Orientation | DeviceNumber | Touch | Distance


@dataclass(frozen=True)
class Observation:
    """A quantity to observe, in an SI unit ("1" if dimensionless)."""

    name: str
    unit: str
    sight: Sight
    line: int

    @property
    def text(self) -> str:
        """A description for people."""
        match self.sight:
            case Coordinate(entity, axis):
                return f"{axis} of {entity}"
            case Velocity(entity, axis):
                return f"velocity {axis} of {entity}"
            case Orientation(entity, part):
                return f"orientation {part} of {entity}"
            case DeviceNumber(device, _, field):
                return f"{field} of {device}"
            case Touch(first, second):
                return f"contact of {first} and {second}"
            case Distance(first, second):
                return f"distance of {first} and {second}"


def read_observation(name: str, block: Block, devices: Mapping[str, DeviceDeclaration | None]) -> Observation | None:
    """Read one entry; None after reporting an error. Malformed devices are None."""
    forms: dict[str, Callable[[], tuple[str, Sight] | None]] = {
        "entity": lambda: _of_entity(block),
        "device": lambda: _of_device(block, devices),
        "contact": lambda: _of_two(block, "contact", "1", Touch),
        "distance": lambda: _of_two(block, "distance", "m", Distance),
    }
    given = [key for key in forms if block.has(key)]
    if len(given) > 1:
        block.problem(f"{block.path}: {' and '.join(given)} are different observations; write one of them", given[1])
        return None
    found = forms[given[0] if given else "entity"]()
    block.finish()
    return None if found is None else Observation(name, found[0], found[1], block.line)


def _of_entity(block: Block) -> tuple[str, Sight] | None:
    entity = block.text("entity")
    given = [key for key in ("axis", "velocity", "orientation") if block.has(key)] or ["axis"]
    if len(given) > 1:
        block.problem(f"{block.path}: {' and '.join(given)} are different observations; write one of them", given[1])
        return None
    (what,) = given
    axis = block.text(what)
    known = QUATERNION if what == "orientation" else AXES
    if axis is not None and axis not in known:
        block.problem(f"{block.path}.{what}: {axis!r} is not one of {', '.join(known)}", what)
        return None
    if entity is None or axis is None:
        return None
    if what == "orientation":
        return "1", Orientation(entity, axis)
    unit = "m" if axis in LINES else "rad"
    return (unit, Coordinate(entity, axis)) if what == "axis" else (f"{unit}/s", Velocity(entity, axis))


def _of_device(block: Block, devices: Mapping[str, DeviceDeclaration | None]) -> tuple[str, Sight] | None:
    name, unit = block.text("device"), block.optional_text("unit", "1")
    field = block.optional_text("field", "")
    if name is None or unit is None or field is None:
        return None
    if name not in devices:
        block.problem(f"{block.path}.device: no device {name!r}; it has {', '.join(devices) or 'none'}", "device")
        return None
    device = devices[name]
    if device is None:
        return None
    fields = KINDS[device.kind].fields(device)
    if not field and len(fields) == 1:
        (field,) = fields
    if field not in fields:
        block.problem(
            f"{block.path}.field: {field!r} is not a number of {name}; it has {', '.join(fields) or 'none'}", "field"
        )
        return None
    return unit, DeviceNumber(name, fields.index(field), field)


def _of_two(block: Block, key: str, unit: str, sight: type[Touch | Distance]) -> tuple[str, Sight] | None:
    names = block.texts(key, required=True)
    return None if names is None else (unit, sight(*names))
