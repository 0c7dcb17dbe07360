"""Faults as parameters: `fault.DEVICE[.FIELD].KIND`, and their parts `.at`, `.for` and `.value`."""

import math
from collections.abc import Mapping
from dataclasses import dataclass

from sitaf_bridge.errors import InvalidRequest, UnreachableValue
from sitaf_bridge.world.description.declaration import MAX_DELAY_S, Description
from sitaf_bridge.world.devices import KINDS, DeviceDeclaration
from sitaf_bridge.world.sensing.faults import FaultKind

PREFIX = "fault."
AT, FOR, VALUE = "at", "for", "value"
IGNORED, SATURATED = "ignored", "saturated"
OF_READINGS = tuple(kind.value for kind in FaultKind)
OF_COMMANDS = (IGNORED, SATURATED)
SWITCHES = ("stuck", "dropout", "out_of_range", *OF_COMMANDS)
# Faults that a boolean cannot have.
OF_NUMBERS = ("offset", "scale", "noise", "out_of_range")
# The booleans in the readings of each kind of device.
BOOLEANS: Mapping[str, tuple[str, ...]] = {"contact": ("pressed",), "digital_io": ("level",)}
# The numbers of commands that have more than one.
COMMAND_FIELDS: Mapping[str, tuple[str, ...]] = {"drive": ("linear", "angular")}
NEUTRAL: Mapping[str, float] = {"scale": 1.0}


@dataclass(frozen=True)
class FaultName:
    """A fault of a device, or one of its parts; `field` is empty for the whole device, `part` for the fault itself."""

    device: str
    field: str
    kind: str
    part: str

    @property
    def fault(self) -> str:
        """The name without its part."""
        return PREFIX + ".".join(filter(None, (self.device, self.field, self.kind)))

    @property
    def default(self) -> float:
        """The value if none is given; no fault, at once, to the end."""
        if self.part in (FOR, VALUE):
            return math.inf
        return 0.0 if self.part else neutral(self.kind)


def is_fault(name: str) -> bool:
    """Whether the name of a parameter is that of a fault."""
    return name.startswith(PREFIX)


def neutral(kind: str) -> float:
    """The value that means no fault."""
    return NEUTRAL.get(kind, 0.0)


def split(name: str) -> FaultName:
    """Split a name without comparing it with a world. Raises InvalidRequest."""
    steps = name.split(".")[1:]
    part = steps.pop() if steps and steps[-1] in (AT, FOR, VALUE) else ""
    if len(steps) < 2 or steps[-1] not in OF_READINGS + OF_COMMANDS:
        kinds = ", ".join(OF_READINGS + OF_COMMANDS)
        raise InvalidRequest(f"parameter {name}: must be fault.DEVICE[.FIELD].KIND[.at|.for|.value]; kinds: {kinds}")
    if part == VALUE and steps[-1] != "out_of_range":
        raise InvalidRequest(f"parameter {name}: only out_of_range has a value")
    return FaultName(steps[0], ".".join(steps[1:-1]), steps[-1], part)


def check_fault_name(name: str, description: Description) -> FaultName:
    """A name that fits a device of the world. Raises InvalidRequest."""
    fault = split(name)
    device = description.devices.get(fault.device)
    if device is None:
        known = ", ".join(description.devices) or "none"
        raise InvalidRequest(f"parameter {name}: no device {fault.device!r}; devices of this world: {known}")
    if not fields_of(fault, device):
        raise InvalidRequest(f"parameter {name}: does not fit a {device.kind}; {_fitting(device)}")
    return fault


def check_fault_value(name: str, fault: FaultName, value: float) -> None:
    """Check a finite value. Raises UnreachableValue."""
    if fault.part == VALUE:
        return
    low, high, shown = 0.0, math.inf, "0 or more"
    if fault.part:
        shown = "0 s or more"
    elif fault.kind in SWITCHES:
        if value not in (0.0, 1.0):
            raise UnreachableValue(f"parameter {name}: {value:g} is neither 0 nor 1")
    elif fault.kind == "intermittent":
        high, shown = 1.0, "a probability from 0 to 1"
    elif fault.kind == "delay":
        high, shown = MAX_DELAY_S, f"0 to {MAX_DELAY_S:g} s"
    elif fault.kind != "noise":
        low = -math.inf
    if not low <= value <= high:
        raise UnreachableValue(f"parameter {name}: {value:g} is not {shown}")


def fields_of(fault: FaultName, device: DeviceDeclaration) -> tuple[str, ...]:
    """The numbers of the reading or of the command that a fault concerns; none if it does not fit the device."""
    kind = KINDS[device.kind]
    if kind.image:
        return ()
    if fault.kind in OF_COMMANDS:
        if kind.takes is None or (fault.kind == SATURATED and (fault.field or kind.takes == "level")):
            return ()
        fields = COMMAND_FIELDS.get(kind.takes, ())
        return tuple(f for f in fields if not fault.field or f == fault.field) or (() if fault.field else ("",))
    found = tuple(
        f for f in kind.fields(device) if not fault.field or f == fault.field or f.startswith(f"{fault.field}.")
    )
    if fault.kind in OF_NUMBERS:
        return tuple(f for f in found if f not in BOOLEANS.get(device.kind, ()))
    return found


def _fitting(device: DeviceDeclaration) -> str:
    kind = KINDS[device.kind]
    fit = [k for k in OF_READINGS + OF_COMMANDS if fields_of(FaultName(device.name, "", k, ""), device)]
    fields = (
        [] if kind.image else list(dict.fromkeys((*kind.fields(device), *COMMAND_FIELDS.get(kind.takes or "", ()))))
    )
    if not fit:
        return "it has no faults"
    return f"its faults: {', '.join(fit)}; its fields: {', '.join(fields[:20])}"
