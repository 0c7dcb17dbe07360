"""The kinds `battery` and `digital_io`, whose state is the `level` of each device."""

from collections.abc import Sequence
from dataclasses import dataclass

import mujoco

from sitaf_bridge.world.description.yaml_block import Block, Problems
from sitaf_bridge.world.devices.kind import Accepted, Command, DeviceDeclaration, DeviceKind, Reading, expected_form

SECONDS_PER_HOUR = 3600.0


@dataclass(frozen=True)
class BatteryDeclaration(DeviceDeclaration):
    """Ampere hours, amperes, empty and full voltage; `level` is the charge at time 0, from 0 to 1."""

    capacity: float
    current: float
    empty: float
    full: float


class BatteryKind(DeviceKind):
    """Kind `battery`: a constant current discharges it in simulation time."""

    name = "battery"

    def declare(self, name: str, block: Block) -> BatteryDeclaration | None:
        """Keys `capacity`, `current`, `voltage`, `level`."""
        capacity, current = block.number("capacity"), block.number("current")
        voltage, level = block.numbers("voltage"), block.optional_number("level", 1.0)
        if capacity is None or current is None or voltage is None or level is None:
            return None
        if capacity <= 0 or current < 0 or not 0 <= voltage[0] <= voltage[1] or not 0 <= level <= 1:
            block.problem(f"{block.path}: needs capacity > 0, current >= 0, voltage [empty, full], level 0 to 1")
            return None
        return BatteryDeclaration(name, self.name, block.line, capacity, current, *voltage, level=level)

    def bind(self, model: mujoco.MjModel, declarations: Sequence[DeviceDeclaration], problems: Problems) -> "LevelBank":
        """A battery has no elements in the model."""
        return LevelBank(declarations)

    def fields(self, declaration: DeviceDeclaration) -> tuple[str, ...]:
        """The fields of sensor_msgs/BatteryState."""
        return ("voltage", "current", "charge", "percentage")


class DigitalIoKind(DeviceKind):
    """Kind `digital_io`: one line, set by the component or by a parameter."""

    name = "digital_io"
    truths = True
    takes = "level"

    def declare(self, name: str, block: Block) -> DeviceDeclaration | None:
        """Key `level`."""
        level = block.optional_number("level", 0.0)
        if level not in (0.0, 1.0):
            block.problem(f"{block.path}.level: must be 0 or 1", "level")
            return None
        return DeviceDeclaration(name, self.name, block.line, level=level)

    def bind(self, model: mujoco.MjModel, declarations: Sequence[DeviceDeclaration], problems: Problems) -> "LevelBank":
        """A line has no elements in the model."""
        return LevelBank(declarations)

    def fields(self, declaration: DeviceDeclaration) -> tuple[str, ...]:
        """One boolean value."""
        return ("level",)


class LevelBank:
    """All devices of one of these kinds."""

    def __init__(self, devices: Sequence[DeviceDeclaration]) -> None:
        self._devices = tuple(devices)
        self._by_name = {d.name: d for d in devices}

    def read(self, model: mujoco.MjModel, data: mujoco.MjData) -> Sequence[Reading]:
        """Read the levels."""
        return [Reading(d, _values(d, float(data.userdata[d.address(model, "level")]), data)) for d in self._devices]

    def write(self, model: mujoco.MjModel, data: mujoco.MjData, command: Command) -> None:
        """Set the level."""
        declaration = self._by_name[command.device]
        data.userdata[declaration.address(model, "level")] = expected_form(command, "level")["level"]

    def accepts(self, model: mujoco.MjModel, device: str) -> Accepted:
        """Both levels."""
        return Accepted({"level": (0.0, 1.0)})

    def actuators(self, device: str) -> tuple[int, ...]:
        """None: a line is no part of the model."""
        return ()


def _values(declaration: DeviceDeclaration, level: float, data: mujoco.MjData) -> tuple[float, ...]:
    if not isinstance(declaration, BatteryDeclaration):
        return (1.0 if level > 0.5 else 0.0,)
    charge = level * declaration.capacity - declaration.current * data.time / SECONDS_PER_HOUR
    left = min(max(charge / declaration.capacity, 0.0), 1.0)
    voltage = declaration.empty + (declaration.full - declaration.empty) * left
    current = -declaration.current if left > 0 else 0.0
    return voltage, current, left * declaration.capacity, left
