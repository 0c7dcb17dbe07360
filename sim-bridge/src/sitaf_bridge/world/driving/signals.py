"""Samples signals at each step: observations, numbers in readings of devices, and commands."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import mujoco
import numpy as np
from numpy.typing import NDArray

from sitaf_bridge.errors import InvalidRequest, LimitReached
from sitaf_bridge.world.description.observation import DeviceNumber
from sitaf_bridge.world.devices import KINDS, Command, Reading
from sitaf_bridge.world.world import World

# 64 MB per case.
MAX_NUMBERS = 8_000_000
COMMAND = "command"
# Simulation time in seconds.
TIME = "t"

Measure = Callable[[mujoco.MjModel, mujoco.MjData, Sequence[Reading], Mapping[str, float]], float]


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

    def __init__(self, names: Sequence[str], settling: bool, world: World, most: int = MAX_NUMBERS) -> None:
        self.settling = settling
        self._names = tuple(names)
        self._most = most
        self._bound: tuple[World, tuple[Measure, ...]] = (world, ())
        # The kinds of devices that need not be read for the signals.
        self.omitted_kinds: frozenset[str] = frozenset()
        self._bind(world)
        self.restart()

    def restart(self) -> None:
        """Delete all samples and commands."""
        self._commands: dict[str, float] = {}
        self._first_step = 0
        self._rows: list[tuple[float, ...]] = []
        self._is_full = False

    @property
    def reads_devices(self) -> bool:
        """Whether a signal depends on readings."""
        return self._reads_devices

    def give(self, commands: Sequence[Command]) -> None:
        """Remember commands that devices accepted."""
        for command in commands:
            for field, value in command.numbers.items():
                self._commands[f"{command.device}.{field}.{COMMAND}"] = value

    def sample(
        self, world: World, model: mujoco.MjModel, data: mujoco.MjData, step: int, readings: Sequence[Reading]
    ) -> None:
        """Sample a step, from data after `mj_forward`; replaces later samples and an earlier one of the same step."""
        if self._bound[0] is not world:
            self._bind(world)
        row = tuple([measure(model, data, readings, self._commands) for measure in self._bound[1]])
        index = step - self._first_step
        if not self._rows or index < 0 or index > len(self._rows):
            self._first_step, self._rows, index = step, [], 0
        if (index + 1) * len(row) > self._most:
            self._is_full = True
            return
        del self._rows[index:]
        self._rows.append(row)

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

    def _bind(self, world: World) -> None:
        devices = [d for d in world.description.devices.values() if not KINDS[d.kind].image]
        measures: dict[str, Measure] = {TIME: lambda _model, data, _readings, _commands: data.time}
        kinds: dict[str, str] = {}
        for position, device in enumerate(devices):
            for index, field in enumerate(KINDS[device.kind].fields(device)):
                measures[f"{device.name}.{field}"] = _reading(position, index)
                kinds[f"{device.name}.{field}"] = device.kind
        for name, bound in world.observations.items():
            measures[name] = _observation(bound.measure)
            sight = world.description.observations[name].sight
            if isinstance(sight, DeviceNumber):
                kinds[name] = world.description.devices[sight.device].kind
        commanded = {d.name for d in devices if KINDS[d.kind].takes is not None}
        for name in self._names:
            if name.endswith(f".{COMMAND}") and name.count(".") == 2 and name.split(".")[0] in commanded:
                measures[name] = _command(name)
            if name not in measures:
                known = ", ".join(list(measures)[:100])
                raise InvalidRequest(f"signals: no signal {name!r}; signals of this world: {known}")
        needed = {kinds[name] for name in self._names if name in kinds}
        self.omitted_kinds = frozenset(d.kind for d in devices) - needed
        self._reads_devices = bool(needed)
        self._bound = world, tuple(measures[name] for name in self._names)


def _reading(position: int, index: int) -> Measure:
    return lambda _model, _data, readings, _commands: readings[position].values[index]


def _observation(measure: Callable[[mujoco.MjModel, mujoco.MjData, Sequence[Reading]], float]) -> Measure:
    return lambda model, data, readings, _commands: measure(model, data, readings)


def _command(name: str) -> Measure:
    return lambda _model, _data, _readings, commands: commands.get(name, 0.0)
