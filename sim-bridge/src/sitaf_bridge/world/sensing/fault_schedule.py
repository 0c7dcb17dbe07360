"""When the faults of a case begin and end, in steps."""

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property

from sitaf_bridge.world.devices import KINDS
from sitaf_bridge.world.sensing.fault_names import (
    AT,
    FOR,
    OF_COMMANDS,
    VALUE,
    FaultName,
    fields_of,
    is_fault,
    neutral,
    split,
)
from sitaf_bridge.world.world import World

# The order in which the faults of a device act on its reading.
ORDER = ("delay", "scale", "offset", "noise", "stuck", "out_of_range", "intermittent", "dropout")


@dataclass(frozen=True)
class ScheduledFault:
    """A fault of one device, active from step `begin` up to, but not at, step `end`.

    `fields` are names of a command's numbers, `positions` those of numbers in the reading. `reading` is what the device
    reads out of range.
    """

    name: str
    device: str
    kind: str
    fields: tuple[str, ...]
    positions: tuple[int, ...]
    value: float
    reading: float
    begin: int
    end: int | None

    def active(self, step: int) -> bool:
        """Whether it acts at a step."""
        return self.begin <= step and (self.end is None or step < self.end)


@dataclass(frozen=True)
class FaultSchedule:
    """The faults of one case. Immutable."""

    faults: tuple[ScheduledFault, ...] = ()

    @cached_property
    def of_readings(self) -> Mapping[str, tuple[ScheduledFault, ...]]:
        """The faults of readings by device, in the order in which they act."""
        return _by_device(sorted((f for f in self.faults if f.kind in ORDER), key=lambda f: ORDER.index(f.kind)))

    @cached_property
    def of_commands(self) -> Mapping[str, tuple[ScheduledFault, ...]]:
        """The faults of commands by device."""
        return _by_device(f for f in self.faults if f.kind in OF_COMMANDS)

    @cached_property
    def changes(self) -> frozenset[int]:
        """The steps at which a fault begins or ends."""
        ends = {f.end for f in self.faults if f.end is not None}
        return frozenset(ends | {f.begin for f in self.faults})

    def steps_to_change(self, step: int) -> int | None:
        """How many steps after a step the next fault begins or ends."""
        return min((change - step for change in self.changes if change > step), default=None)

    def needs_past(self, step: int) -> bool:
        """Whether a delay acts now or later, so that past readings must be known."""
        return any(f.kind == "delay" and (f.end is None or step < f.end) for f in self.faults)

    def shifted(self, steps: int) -> "FaultSchedule":
        """The same faults that many steps later."""
        return FaultSchedule(
            tuple(replace(f, begin=f.begin + steps, end=None if f.end is None else f.end + steps) for f in self.faults)
        )

    def updated(self, world: World, values: Mapping[str, float], changed: Iterable[str], step: int) -> "FaultSchedule":
        """With the faults that the names of `changed` concern beginning again, counted from a step.

        `values` are all parameters of the case.
        """
        restarted = dict.fromkeys(split(name).fault for name in changed if is_fault(name))
        if not restarted:
            return self
        kept = [fault for fault in self.faults if fault.name not in restarted]
        begun = (_scheduled(split(name), world, values, step) for name in restarted)
        return FaultSchedule((*kept, *(fault for fault in begun if fault is not None)))


def _by_device(faults: Iterable[ScheduledFault]) -> Mapping[str, tuple[ScheduledFault, ...]]:
    found: dict[str, tuple[ScheduledFault, ...]] = {}
    for fault in faults:
        found[fault.device] = (*found.get(fault.device, ()), fault)
    return found


def _scheduled(name: FaultName, world: World, values: Mapping[str, float], step: int) -> ScheduledFault | None:
    """A fault as the values say; None if they say that there is none."""
    shown = name.fault
    value = values.get(shown, neutral(name.kind))
    begin_s = values.get(f"{shown}.{AT}", 0.0)
    length_s = values.get(f"{shown}.{FOR}", math.inf)
    if value == neutral(name.kind) or length_s <= 0:
        return None
    device = world.description.devices[name.device]
    fields = fields_of(name, device)
    every = () if name.kind in OF_COMMANDS else KINDS[device.kind].fields(device)
    return ScheduledFault(
        name=shown,
        device=name.device,
        kind=name.kind,
        fields=fields,
        positions=tuple(i for i, field in enumerate(every) if field in fields),
        value=value,
        reading=values.get(f"{shown}.{VALUE}", math.inf),
        begin=step + _steps(begin_s, world),
        end=None if math.isinf(length_s) else step + _steps(begin_s + length_s, world),
    )


def _steps(seconds: float, world: World) -> int:
    # A time that is a whole number of steps, except for its rounding, is that number.
    return math.ceil(seconds * 1e9 / world.timestep_ns - 1e-6)
