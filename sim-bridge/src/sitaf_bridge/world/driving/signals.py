"""Samples signals at each step: observations, numbers in readings of devices, and commands."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import mujoco
import numpy as np
from numpy.typing import NDArray

from sitaf_bridge.errors import InvalidRequest, LimitReached
from sitaf_bridge.world.description.observation import DeviceNumber
from sitaf_bridge.world.description.yaml_block import Problems
from sitaf_bridge.world.devices import KINDS, Command
from sitaf_bridge.world.observing import Measure
from sitaf_bridge.world.sensing.live import SHADOW_ERROR, LiveDevices
from sitaf_bridge.world.sensing.sensing import Sensing
from sitaf_bridge.world.world import World, bind_devices

# 64 MB per case.
MAX_NUMBERS = 8_000_000
COMMAND = "command"
# Simulation time in seconds.
TIME = "t"


@dataclass(frozen=True)
class Trace:
    """Samples of one case at consecutive steps: `values` has one row per sample, one column per signal.

    `first_ns` is the time of the first sample relative to the call.
    """

    first_ns: int
    timestep_ns: int
    names: tuple[str, ...]
    values: NDArray[np.float64]


class SignalRecording:
    """Records the named signals of each case; `settling` also while the world settles. Raises InvalidRequest."""

    def __init__(
        self,
        names: Sequence[str],
        settling: bool,
        world: World,
        most: int = MAX_NUMBERS,
        live: LiveDevices | None = None,
    ) -> None:
        self.settling = settling
        self._live = live
        self._names = tuple(names)
        self._most_rows = most // max(1, len(self._names))
        self._most = most
        self._commands: dict[str, float] = {}
        self.bind(world)
        self.restart()

    def restart(self) -> None:
        """Delete all samples and commands."""
        self._commands.clear()
        self._first_step = 0
        self._rows: list[list[float]] = []
        self._is_full = False

    @property
    def next_step(self) -> int:
        """The step after the last sample."""
        return self._first_step + len(self._rows)

    def give(self, commands: Sequence[Command]) -> None:
        """Remember commands that devices accepted."""
        for command in commands:
            for field, value in command.numbers.items():
                self._commands[f"{command.device}.{field}.{COMMAND}"] = value

    def sample(self, model: mujoco.MjModel, data: mujoco.MjData, step: int, sensing: Sensing) -> None:
        """Sample a step, from data after `mj_forward`; replaces later samples and an earlier one of the same step."""
        readings = sensing.read_banks(model, data, step, self._banks) if self._banks else ()
        row = [measure(model, data, readings) for measure in self._measures]
        rows, index = self._rows, step - self._first_step
        if index != len(rows):
            if not rows or index < 0 or index > len(rows):
                self._first_step, index = step, 0
            del rows[index:]
        if index >= self._most_rows:
            self._is_full = True
            return
        rows.append(row)

    def trace(self, call_ns: int, timestep_ns: int) -> Trace:
        """The samples of a case whose call began at this simulation time. Raises InvalidRequest, LimitReached."""
        if self._is_full:
            raise LimitReached(
                f"signals: {len(self._names)} signals in more than {len(self._rows)} steps; "
                f"the limit of one case is {self._most} numbers"
            )
        begin = 0 if self.settling else max(0, call_ns // timestep_ns - self._first_step)
        rows = self._rows[begin:]
        if not rows:
            raise InvalidRequest("call_time_ns: is after the last sample")
        first_ns = (self._first_step + begin) * timestep_ns - call_ns
        return Trace(
            first_ns, timestep_ns, self._names, np.array(rows, np.float64).reshape(len(rows), len(self._names))
        )

    def bind(self, world: World) -> None:
        """Find the signals in a world, of whose devices only the needed ones are read. Raises InvalidRequest."""
        numbers = _numbers(world)
        devices = {numbers[name].device: None for name in self._names if name in numbers}
        declared = world.description.devices
        live = self._live
        shadows = {} if live is None else {f"{device}.{SHADOW_ERROR}": device for device in live.shadows()}
        devices.update({shadows[name]: None for name in self._names if name in shadows})
        banks = bind_devices(world.model, [declared[name] for name in devices], Problems(world.source.description))
        self._banks = tuple(banks.values())
        # In the order in which the banks are read.
        positions = {name: i for i, name in enumerate(n for kind in banks for n in devices if declared[n].kind == kind)}
        commanded = {d.name for d in declared.values() if KINDS[d.kind].takes is not None}
        measures: list[Measure] = []
        for name in self._names:
            if name in numbers:
                measures.append(_reading(positions[numbers[name].device], numbers[name].field))
            elif live is not None and name in shadows:
                measures.append(_shadow(live, shadows[name]))
            elif name == TIME:
                measures.append(lambda _model, data, _readings: data.time)
            elif name in world.observations:
                measures.append(world.observations[name].measure)
            elif name.endswith(f".{COMMAND}") and name.count(".") == 2 and name.split(".")[0] in commanded:
                measures.append(self._command(name))
            else:
                known = ", ".join(list(dict.fromkeys((TIME, *numbers, *shadows, *world.observations)))[:100])
                raise InvalidRequest(f"signals: no signal {name!r}; signals of this world: {known}")
        self._measures = tuple(measures)

    def _command(self, name: str) -> Measure:
        commands = self._commands
        return lambda _model, _data, _readings: commands.get(name, 0.0)


class _Number(NamedTuple):
    """A number in the readings of a device."""

    device: str
    field: int


def _numbers(world: World) -> dict[str, _Number]:
    """The signals that are read from devices: their fields, and the observations of them."""
    devices = [d for d in world.description.devices.values() if not KINDS[d.kind].image]
    found = {
        f"{d.name}.{_signal(field)}": _Number(d.name, i)
        for d in devices
        for i, field in enumerate(KINDS[d.kind].fields(d))
    }
    for name, observation in world.description.observations.items():
        if isinstance(observation.sight, DeviceNumber):
            found[name] = _Number(observation.sight.device, observation.sight.index)
    return found


def _signal(field: str) -> str:
    """The name of a field in formulas, which write the elements of lists with brackets."""
    head, _, tail = field.rpartition(".")
    return f"{head}[{tail}]" if tail.isdecimal() else field


def _shadow(live: LiveDevices, device: str) -> Measure:
    return lambda _model, _data, _readings: live.shadow_error(device)


def _reading(position: int, index: int) -> Measure:
    return lambda _model, _data, readings: readings[position].values[index]
