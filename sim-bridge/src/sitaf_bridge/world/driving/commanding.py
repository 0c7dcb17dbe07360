"""Runs commands of the robot's actuators."""

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import cast

import mujoco

from sitaf_bridge.errors import InvalidRequest
from sitaf_bridge.world.devices import KINDS, Command
from sitaf_bridge.world.devices.kind import ActuatorBank
from sitaf_bridge.world.sensing.fault_names import IGNORED, SATURATED
from sitaf_bridge.world.sensing.fault_schedule import FaultSchedule
from sitaf_bridge.world.world import World


@dataclass(frozen=True)
class Moment:
    """A simulation at one step."""

    world: World
    model: mujoco.MjModel
    data: mujoco.MjData
    faults: FaultSchedule
    step: int


class Commanding:
    """The commands that the actuators of one simulation follow, with the scheduled faults of commands."""

    def __init__(self) -> None:
        self._followed: dict[str, Command] = {}

    def reset(self) -> None:
        """Forget all commands."""
        self._followed = {}

    def memory(self) -> Mapping[str, Command]:
        """A copy of the complete state."""
        return dict(self._followed)

    def remember(self, memory: Mapping[str, Command]) -> None:
        """Restore a copy."""
        self._followed = dict(memory)

    def give(self, commands: Sequence[Command], now: Moment) -> Sequence[Command]:
        """Run the commands in order; returns what the actuators follow of them.

        Raises InvalidRequest, UnreachableValue for the first invalid one.
        """
        given: list[Command] = []
        for command in commands:
            bank = _bank(command, now.world)
            if not now.faults.of_commands.get(command.device):
                bank.write(now.model, now.data, command)
                self._followed[command.device] = command
                given.append(command)
                continue
            # A command that the actuator ignores is refused like any other.
            control, knobs = now.data.ctrl.copy(), now.data.userdata.copy()
            bank.write(now.model, now.data, command)
            now.data.ctrl[:], now.data.userdata[:] = control, knobs
            followed = self._effective(command, now)
            if followed is not None:
                self._followed[command.device] = followed
                self._write(command.device, now)
                given.append(followed)
        return given

    def refresh(self, devices: Iterable[str], now: Moment) -> None:
        """Let the actuators of devices follow the faults that began or ended at a step."""
        for device in devices:
            if device in self._followed:
                self._write(device, now)

    def _effective(self, command: Command, now: Moment) -> Command | None:
        """What the actuator follows of a command; None if it ignores all of it."""
        ignored = {
            field
            for fault in now.faults.of_commands[command.device]
            if fault.kind == IGNORED and fault.active(now.step)
            for field in fault.fields
        }
        if "" in ignored or ignored >= set(command.numbers):
            return None
        before = self._followed.get(command.device)
        earlier = {} if before is None else before.numbers
        numbers = {
            name: earlier.get(name, 0.0) if name in ignored else value for name, value in command.numbers.items()
        }
        return Command(command.device, command.form, numbers)

    def _write(self, device: str, now: Moment) -> None:
        bank = cast(ActuatorBank, now.world.banks[now.world.description.devices[device].kind])
        bank.write(now.model, now.data, self._followed[device])
        faults = now.faults.of_commands.get(device, ())
        if any(fault.kind == SATURATED and fault.active(now.step) for fault in faults):
            for actuator in bank.actuators(device):
                low, high = now.model.actuator_ctrlrange[actuator].tolist()
                control = float(now.data.ctrl[actuator])
                now.data.ctrl[actuator] = control if control == 0 else high if control > 0 else low


def check_saturable(device: str, world: World) -> None:
    """Raise InvalidRequest unless all actuators of a device have limits."""
    bank = cast(ActuatorBank, world.banks[world.description.devices[device].kind])
    if not all(world.model.actuator_ctrllimited[actuator] for actuator in bank.actuators(device)):
        raise InvalidRequest(
            f"parameter fault.{device}.saturated: an actuator of {device} has no limits; "
            "give it a ctrlrange in the MJCF"
        )


def _bank(command: Command, world: World) -> ActuatorBank:
    """The bank of a command with finite numbers. Raises InvalidRequest."""
    device = world.description.devices.get(command.device)
    if device is None:
        known = ", ".join(world.description.devices) or "none"
        raise InvalidRequest(f"commands: no device {command.device!r}; devices of this world: {known}")
    if KINDS[device.kind].takes is None:
        raise InvalidRequest(f"commands: {command.device} is a {device.kind}, which accepts no commands")
    for name, value in command.numbers.items():
        if not math.isfinite(value):
            raise InvalidRequest(f"commands: {command.device}.{name}: {value} is not a finite number")
    return cast(ActuatorBank, world.banks[device.kind])
