"""The readings of the devices of one simulation, with noise, delay and faults."""

import math
from collections.abc import Collection, Mapping, Sequence

import mujoco
import numpy as np

from sitaf_bridge.errors import InvalidRequest
from sitaf_bridge.world.devices import KINDS, KNOBS, Bank, Reading
from sitaf_bridge.world.sensing.faults import MAX_FAULTS, Fault, FaultKind, apply_fault, check_fault
from sitaf_bridge.world.sensing.noise import gaussian, stream
from sitaf_bridge.world.world import World

History = tuple[tuple[int, tuple[float, ...]], ...]
Memory = tuple[Mapping[str, tuple[Fault, ...]], Mapping[str, History]]


class Sensing:
    """Faults and the past readings of delayed devices; the devices' noise and delay are in the userdata."""

    def __init__(self, world: World, seed: int) -> None:
        self.world = world
        self._seed = seed
        self._faults: dict[str, tuple[Fault, ...]] = {}
        self._past: dict[str, list[tuple[int, tuple[float, ...]]]] = {}

    def reset(self) -> None:
        """Remove all faults and past readings."""
        self._faults = {}
        self._past = {}

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
        return dict(self._faults), {name: tuple(past) for name, past in self._past.items()}

    def remember(self, memory: Memory) -> None:
        """Restore a copy."""
        self._faults = dict(memory[0])
        self._past = {name: list(past) for name, past in memory[1].items()}

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

    def keeps_past(self, data: mujoco.MjData) -> bool:
        """Whether any device is delayed, so that every step must be read."""
        if any(f.kind is FaultKind.DELAY for faults in self._faults.values() for f in faults):
            return True
        return any(self._knobs(data)[1 :: len(KNOBS)])

    def read(
        self, model: mujoco.MjModel, data: mujoco.MjData, step: int, without: Collection[str] = ()
    ) -> tuple[Reading, ...]:
        """The readings in the order of declaration, from data after `mj_forward`.

        Devices of the kinds in `without` are skipped and have no values; not allowed if a device is delayed.
        """
        banks = self.world.banks
        actual = [reading for kind in banks if kind not in without for reading in banks[kind].read(model, data)]
        if without:
            devices = self.world.description.devices.values()
            actual += [Reading(device, ()) for device in devices if device.kind in without and device.kind in banks]
        if len(self.world.banks) > 1:
            actual.sort(key=lambda reading: -reading.device.slot)
        return tuple(self._perceived(model, data, step, actual))

    def read_banks(
        self, model: mujoco.MjModel, data: mujoco.MjData, step: int, banks: Sequence[Bank]
    ) -> Sequence[Reading]:
        """The readings of the devices of these banks, in their order, from data after `mj_forward`."""
        return self._perceived(model, data, step, [reading for bank in banks for reading in bank.read(model, data)])

    def _perceived(
        self, model: mujoco.MjModel, data: mujoco.MjData, step: int, actual: Sequence[Reading]
    ) -> Sequence[Reading]:
        """With noise, delay and faults."""
        if not self._faults and not any(self._knobs(data)):
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
        if delay > 0:
            values = self._earlier(device.name, step, values, delay)
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
        return actual if moved is actual.values else Reading(device, kind.limited(device, moved))

    def _earlier(self, name: str, step: int, now: tuple[float, ...], delay_s: float) -> tuple[float, ...]:
        """Store `now` and return the reading before the delay, or the earliest one that is known."""
        past = self._past.setdefault(name, [])
        if past and past[-1][0] == step:
            past[-1] = (step, now)
        else:
            past.append((step, now))
        is_active = step - math.ceil(delay_s * 1e9 / self.world.timestep_ns - 1e-6)
        first = 0
        while first + 1 < len(past) and past[first + 1][0] <= is_active:
            first += 1
        del past[:first]
        return past[0][1]
