"""Runs commands of the robot's actuators."""

import math
from collections.abc import Sequence
from typing import cast

import mujoco

from sitaf_bridge.errors import InvalidRequest
from sitaf_bridge.world.devices import KINDS, Command
from sitaf_bridge.world.devices.kind import ActuatorBank
from sitaf_bridge.world.world import World


def give(commands: Sequence[Command], world: World, model: mujoco.MjModel, data: mujoco.MjData) -> None:
    """Run the commands in order. Raises InvalidRequest, UnreachableValue for the first invalid one."""
    for command in commands:
        device = world.description.devices.get(command.device)
        if device is None:
            known = ", ".join(world.description.devices) or "none"
            raise InvalidRequest(f"commands: no device {command.device!r}; devices of this world: {known}")
        if KINDS[device.kind].takes is None:
            raise InvalidRequest(f"commands: {command.device} is a {device.kind}, which accepts no commands")
        for name, value in command.numbers.items():
            if not math.isfinite(value):
                raise InvalidRequest(f"commands: {command.device}.{name}: {value} is not a finite number")
        cast(ActuatorBank, world.banks[device.kind]).write(model, data, command)
