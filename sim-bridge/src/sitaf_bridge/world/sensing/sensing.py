"""The readings of the devices of one simulation, with noise, delay and faults."""

import math
from bisect import bisect_right
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass

import mujoco
import numpy as np

from sitaf_bridge.errors import InvalidRequest
from sitaf_bridge.world.devices import KINDS, KNOBS, Bank, DeviceDeclaration, Reading
from sitaf_bridge.world.sensing.fault_schedule import FaultSchedule, ScheduledFault
from sitaf_bridge.world.sensing.faults import MAX_FAULTS, Fault, FaultKind, Values, apply_fault, check_fault
from sitaf_bridge.world.sensing.live import LiveDevices
from sitaf_bridge.world.sensing.noise import gaussian, stream
from sitaf_bridge.world.world import World

History = tuple[tuple[int, tuple[float, ...]], ...]
# Faults that act on a reading that was limited to what the device can measure.
UNLIMITED = ("out_of_range", "intermittent", "dropout")


@dataclass(frozen=True)
class Memory:
    """The complete state: faults, the past of delayed devices, the schedule, and what stuck devices hold."""

    faults: Mapping[str, tuple[Fault, ...]]
    past: Mapping[str, History]
    schedule: FaultSchedule
    held: Mapping[str, tuple[float, ...]]


class Sensing:
    """Faults and the past readings of delayed devices; the devices' noise and delay are in the userdata.

    `schedule` has the faults that are parameters.
    """

    def __init__(self, world: World, seed: int) -> None:
        self.world = world
        self._seed = seed
        self._faults: dict[str, tuple[Fault, ...]] = {}
        self._past: dict[str, list[tuple[int, tuple[float, ...]]]] = {}
        self.schedule = FaultSchedule()
        self._held: dict[str, tuple[float, ...]] = {}
        # Replaces readings before noise, delay and faults; None if all devices are simulated.
        self.live: LiveDevices | None = None

    def reset(self) -> None:
        """Remove all faults and past readings."""
        self._faults = {}
        self._past = {}
        self.follow(FaultSchedule())

    def follow(self, schedule: FaultSchedule) -> None:
        """Replace the schedule; devices that it lets stick hold their readings from the beginning of that fault."""
        left = {fault.name for fault in schedule.faults if fault in self.schedule.faults}
        self._held = {name: held for name, held in self._held.items() if name in left}
        self.schedule = schedule

    def set_knobs(self, model: mujoco.MjModel, data: mujoco.MjData) -> None:
        """Set noise, delay and level of the devices as declared, in data after a reset."""
        for device in self.world.description.devices.values():
            for knob in KNOBS:
                value = getattr(device, knob)
                if value:
                    data.userdata[device.address(model, knob)] = value

    def clear_history(self) -> None:
        """Delete past readings, for example after a reset of time."""
        self._past = {}

    def memory(self) -> Memory:
        """A copy of the complete state."""
        past = {name: tuple(past) for name, past in self._past.items()}
        return Memory(dict(self._faults), past, self.schedule, dict(self._held))

    def remember(self, memory: Memory) -> None:
        """Restore a copy."""
        self._faults = dict(memory.faults)
        self._past = {name: list(past) for name, past in memory.past.items()}
        self.schedule, self._held = memory.schedule, dict(memory.held)

    def set_faults(self, device: str, faults: Sequence[Fault], now: tuple[float, ...]) -> None:
        """Replace the faults of a device whose current reading is `now`. Raises InvalidRequest."""
        declaration = self.world.description.devices.get(device)
        if declaration is None:
            known = ", ".join(self.world.description.devices) or "none"
            raise InvalidRequest(f"device: no device {device!r}; devices of this world: {known}")
        if KINDS[declaration.kind].image:
            raise InvalidRequest(f"device: {device} is a camera, which has no faults")
        if len(faults) > MAX_FAULTS:
            raise InvalidRequest(f"faults: {len(faults)} for one device; the limit is {MAX_FAULTS}")
        for fault in faults:
            check_fault(device, fault)
        self._faults[device] = tuple(Fault(f.kind, f.value, now if f.kind is FaultKind.STUCK else ()) for f in faults)
        if not faults:
            del self._faults[device]

    def keeps_past(self, data: mujoco.MjData, step: int) -> bool:
        """Whether any device is delayed, so that every step must be read."""
        if self.schedule.needs_past(step):
            return True
        if any(f.kind is FaultKind.DELAY for faults in self._faults.values() for f in faults):
            return True
        return any(self._knobs(data)[1 :: len(KNOBS)])

    def read(
        self, model: mujoco.MjModel, data: mujoco.MjData, step: int, without: Collection[str] = ()
    ) -> tuple[Reading, ...]:
        """The readings in the order of declaration, from data after `mj_forward`.

        Devices of the kinds in `without` are skipped and have no values; not allowed if a device is delayed.
        """
        found: list[Reading] = []
        for kind, bank in self.world.banks.items():
            found += self._unread(kind) if kind in without else bank.read(model, data)
        actual = [found[position] for position in self.world.places_of_readings]
        return tuple(self._perceived(model, data, step, self._real(step, actual)))

    def _unread(self, kind: str) -> list[Reading]:
        return [Reading(device, ()) for device in self.world.description.devices.values() if device.kind == kind]

    def read_banks(
        self, model: mujoco.MjModel, data: mujoco.MjData, step: int, banks: Sequence[Bank]
    ) -> Sequence[Reading]:
        """The readings of the devices of these banks, in their order, from data after `mj_forward`."""
        actual = [reading for bank in banks for reading in bank.read(model, data)]
        return self._perceived(model, data, step, self._real(step, actual))

    def faulty(self, step: int, readings: Sequence[Reading]) -> Sequence[Reading]:
        """With scheduled faults only, of devices without noise and delay."""
        return [self._faulty(reading.device, step, reading.values, reading) for reading in readings]

    def _real(self, step: int, actual: Sequence[Reading]) -> Sequence[Reading]:
        return actual if self.live is None else self.live.perceived(step, actual)

    def _perceived(
        self, model: mujoco.MjModel, data: mujoco.MjData, step: int, actual: Sequence[Reading]
    ) -> Sequence[Reading]:
        """With noise, delay and faults."""
        if not self._faults and not self.schedule.of_readings and not any(self._knobs(data)):
            return actual
        return [self._read(model, data, step, reading) for reading in actual]

    def _knobs(self, data: mujoco.MjData) -> list[float]:
        """The knobs of all devices, as lists, which are faster than arrays for few numbers."""
        count = len(self.world.description.devices)
        return data.userdata.tolist()[-len(KNOBS) * count :] if count else []

    def _read(self, model: mujoco.MjModel, data: mujoco.MjData, step: int, actual: Reading) -> Reading:
        device, values = actual.device, actual.values
        faults = self._faults.get(device.name, ())
        delay = float(data.userdata[device.address(model, "delay")])
        delay += sum(fault.value for fault in faults if fault.kind is FaultKind.DELAY)
        scheduled = [f for f in self.schedule.of_readings.get(device.name, ()) if f.kind == "delay"]
        if delay > 0 or any(f.end is None or step < f.end for f in scheduled):
            values = self._earlier(device.name, step, values, delay, scheduled)
        else:
            self._past.pop(device.name, None)
        moved = values
        noise = float(data.userdata[device.address(model, "noise")])
        kind = KINDS[device.kind]
        if noise > 0 and not kind.truths:
            drawn = gaussian(stream(self._seed, device.name), step, len(values))
            moved = tuple((np.array(values) + noise * drawn).tolist())
        for index, fault in enumerate(faults):
            key = stream(self._seed, f"{device.name}/fault/{index}")
            moved = apply_fault(moved, fault, key, device, step)
        return self._faulty(device, step, moved, actual)

    def _faulty(self, device: DeviceDeclaration, step: int, values: Values, actual: Reading) -> Reading:
        """The reading `values` with scheduled faults; `actual` is what the world is like."""
        moved = values
        if not values:
            return actual
        active = [f for f in self.schedule.of_readings.get(device.name, ()) if f.kind != "delay" and f.active(step)]
        for fault in active:
            if fault.kind not in UNLIMITED:
                moved = self._changed(moved, fault, device, step)
        if moved is not actual.values:
            moved = KINDS[device.kind].limited(device, moved)
        for fault in active:
            if fault.kind in UNLIMITED:
                moved = self._changed(moved, fault, device, step)
        return actual if moved is actual.values else Reading(device, moved)

    def _changed(self, values: Values, fault: ScheduledFault, device: DeviceDeclaration, step: int) -> Values:
        """The reading with one fault of some of its numbers."""
        concerned = tuple(values[i] for i in fault.positions)
        if fault.kind == FaultKind.STUCK.value:
            changed = self._held.setdefault(fault.name, concerned)
        elif fault.kind == FaultKind.OUT_OF_RANGE.value:
            changed = (fault.reading,) * len(concerned)
        else:
            key = stream(self._seed, fault.name)
            changed = apply_fault(concerned, Fault(FaultKind(fault.kind), fault.value), key, device, step)
        return replaced(values, fault.positions, changed)

    def _earlier(
        self, name: str, step: int, now: Values, delay_s: float, scheduled: Sequence[ScheduledFault]
    ) -> Values:
        """Store `now` and return the reading before the delay, or the earliest one that is known.

        Scheduled delays are added for the numbers that they concern.
        """
        past = self._past.setdefault(name, [])
        if past and past[-1][0] == step:
            past[-1] = (step, now)
        else:
            past.append((step, now))
        longest = delay_s + sum(fault.value for fault in scheduled)
        del past[: self._at(past, step, longest)]
        values = past[self._at(past, step, delay_s)][1]
        for position in {position for fault in scheduled for position in fault.positions}:
            delay = sum(f.value for f in scheduled if position in f.positions and f.active(step))
            if delay > 0:
                earlier = past[self._at(past, step, delay_s + delay)][1]
                values = replaced(values, (position,), (earlier[position],))
        return values

    def _at(self, past: Sequence[tuple[int, Values]], step: int, delay_s: float) -> int:
        """The index of the last reading that is as old as the delay, or of the first one."""
        oldest = step - math.ceil(delay_s * 1e9 / self.world.timestep_ns - 1e-6)
        return max(0, bisect_right(past, oldest, key=lambda entry: entry[0]) - 1)


def replaced(values: Values, positions: Sequence[int], changed: Values) -> Values:
    """A copy with other numbers at some positions."""
    copied = list(values)
    for position, value in zip(positions, changed, strict=True):
        copied[position] = value
    return tuple(copied)
