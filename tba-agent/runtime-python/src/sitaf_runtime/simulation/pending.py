"""Commands of a component that travel with the next step."""

from __future__ import annotations

import math
import threading
from collections.abc import Mapping

from sitaf_runtime.simulation.wire.sitaf.sim.v1 import simulation_pb2 as pb

# Commands without a step between them are sent when there are so many.
_MAX_COMMANDS = 1024


class PendingCommands:
    """Commands that their devices are known to accept, in the order given. Thread-safe."""

    def __init__(self, world: pb.WorldDescription) -> None:
        self._limits = {
            device.name: {number.name: (number.min, number.max) for number in device.commands}
            for device in world.devices
        }
        self._bounds = {device.name: tuple(device.bounds) for device in world.devices}
        self._commands: list[pb.DeviceCommand] = []
        self._changing = threading.Lock()

    def __bool__(self) -> bool:
        return bool(self._commands)

    @property
    def is_full(self) -> bool:
        """Whether the commands must be sent before another one is added."""
        return len(self._commands) >= _MAX_COMMANDS

    def is_acceptable(self, command: pb.DeviceCommand) -> bool:
        """Whether the device is known to accept a command: its numbers are finite and within limits."""
        numbers = _numbers(command)
        limits = self._limits.get(command.device)
        if not numbers or limits is None:
            return False
        for name, value in numbers.items():
            accepted = limits.get(name)
            if accepted is None or not math.isfinite(value) or not accepted[0] <= value <= accepted[1]:
                return False
        return all(_is_inside(bound, numbers) for bound in self._bounds[command.device])

    def add(self, command: pb.DeviceCommand) -> None:
        """Add a command that is acceptable."""
        with self._changing:
            self._commands.append(command)

    def take(self) -> list[pb.DeviceCommand]:
        """Remove and return all commands."""
        with self._changing:
            taken, self._commands = self._commands, []
            return taken


def _is_inside(bound: pb.CommandBound, numbers: Mapping[str, float]) -> bool:
    total = sum(factor * numbers.get(name, 0.0) for name, factor in bound.factors.items())
    return bound.min <= total <= bound.max


def _numbers(command: pb.DeviceCommand) -> dict[str, float]:
    form: str | None = command.WhichOneof("command")
    if form == "joint":
        joint = command.joint
        target: str | None = joint.WhichOneof("target")
        return {} if target is None else {target: getattr(joint, target)}
    if form == "drive":
        return {"linear": command.drive.linear, "angular": command.drive.angular}
    if form == "gripper":
        return {"width": command.gripper.width_m}
    return {"level": float(command.level)} if form == "level" else {}
