"""Kinds `differential_drive` and `gripper`: several actuators with one command."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import mujoco

from sitaf_bridge.errors import UnreachableValue
from sitaf_bridge.world.description.yaml_block import Block, Problems
from sitaf_bridge.world.devices.binding import (
    BindingError,
    Joint,
    command_actuator,
    find,
    find_all,
    joint_of,
    limits_of,
    mode_of,
)
from sitaf_bridge.world.devices.kind import (
    Accepted,
    Bound,
    Command,
    DeviceDeclaration,
    DeviceKind,
    Reading,
    expected_form,
)

# The share of a limit below which a command might be refused after rounding.
_ROUNDING = 1e-9


@dataclass(frozen=True)
class DriveDeclaration(DeviceDeclaration):
    """Lengths in metres; positive controls turn the wheels forward."""

    left: str
    right: str
    wheel_radius: float
    track: float


@dataclass(frozen=True)
class GripperDeclaration(DeviceDeclaration):
    """Two fingers; `width` is their distance when open, in metres."""

    fingers: tuple[str, str]
    width: float


@dataclass(frozen=True)
class _Pair:
    """Two actuators, and the joints that they drive."""

    actuators: tuple[int, int]
    joints: tuple[Joint, Joint]


def _pair(model: mujoco.MjModel, names: tuple[str, str], keys: tuple[str, str], mode: str) -> _Pair:
    actuators, joints = [], []
    for name, key in zip(names, keys, strict=True):
        actuator = find(model, "actuator", name, key)
        if mode_of(model, actuator, key) != mode:
            raise BindingError(key, f"the actuator {name!r} must be a <{mode}>")
        actuators.append(actuator)
        joints.append(joint_of(model, actuator, key))
    return _Pair((actuators[0], actuators[1]), (joints[0], joints[1]))


class DifferentialDriveKind(DeviceKind):
    """Kind `differential_drive`."""

    name = "differential_drive"
    takes = "drive"

    def declare(self, name: str, block: Block) -> DriveDeclaration | None:
        """Keys `left`, `right`, `wheel_radius`, `track`."""
        left, right = block.text("left"), block.text("right")
        radius, track = block.number("wheel_radius"), block.number("track")
        if left is None or right is None or radius is None or track is None:
            return None
        if radius <= 0 or track <= 0:
            block.problem(f"{block.path}: wheel_radius and track must be positive")
            return None
        return DriveDeclaration(name, self.name, block.line, left, right, radius, track)

    def bind(self, model: mujoco.MjModel, declarations: Sequence[DeviceDeclaration], problems: Problems) -> "DriveBank":
        """Find the velocity actuators."""

        def wheels(declaration: DeviceDeclaration) -> _Pair:
            assert isinstance(declaration, DriveDeclaration)  # noqa: S101
            return _pair(model, (declaration.left, declaration.right), ("left", "right"), "velocity")

        return DriveBank(find_all(declarations, problems, wheels))

    def fields(self, declaration: DeviceDeclaration) -> tuple[str, ...]:
        """The pose and velocity from wheel odometry."""
        return ("linear", "angular", "left_position", "right_position")


class DriveBank:
    """All differential drives of a world."""

    def __init__(self, devices: Sequence[tuple[DeviceDeclaration, _Pair]]) -> None:
        self._devices = tuple(devices)
        self._by_name = {d.name: (d, pair) for d, pair in devices}

    def read(self, model: mujoco.MjModel, data: mujoco.MjData) -> Sequence[Reading]:
        """Compute the readings from the rotation of the wheels."""
        readings: list[Reading] = []
        for declaration, pair in self._devices:
            assert isinstance(declaration, DriveDeclaration)  # noqa: S101
            left, right = (data.qvel.item(joint.velocity) * declaration.wheel_radius for joint in pair.joints)
            positions = (data.qpos.item(joint.position) for joint in pair.joints)
            readings.append(Reading(declaration, ((left + right) / 2, (right - left) / declaration.track, *positions)))
        return readings

    def write(self, model: mujoco.MjModel, data: mujoco.MjData, command: Command) -> None:
        """Convert the vehicle's velocity to wheel speeds."""
        declaration, pair = self._by_name[command.device]
        assert isinstance(declaration, DriveDeclaration)  # noqa: S101
        numbers = expected_form(command, "drive")
        turning = numbers["angular"] * declaration.track / 2
        for actuator, speed, side in zip(
            pair.actuators, (numbers["linear"] - turning, numbers["linear"] + turning), ("left", "right"), strict=True
        ):
            shown = f"{command.device}: {side} wheel in rad/s"
            command_actuator(model, data, actuator, speed / declaration.wheel_radius, shown)

    def accepts(self, model: mujoco.MjModel, device: str) -> Accepted:
        """Any velocity that both wheels reach."""
        declaration, pair = self._by_name[device]
        assert isinstance(declaration, DriveDeclaration)  # noqa: S101
        bounds: list[Bound] = []
        for actuator, side in zip(pair.actuators, (-1, 1), strict=True):
            if model.actuator_ctrllimited[actuator]:
                low, high = limits_of(model, actuator)
                # `write` rounds in another order.
                margin = _ROUNDING * max(abs(low), abs(high))
                turning = side * declaration.track / 2
                factors = {"linear": 1 / declaration.wheel_radius, "angular": turning / declaration.wheel_radius}
                bounds.append(Bound(factors, (low + margin, high - margin)))
        return Accepted({"linear": (-math.inf, math.inf), "angular": (-math.inf, math.inf)}, bounds)

    def actuators(self, device: str) -> tuple[int, ...]:
        """The actuators of both wheels."""
        return self._by_name[device][1].actuators


class GripperKind(DeviceKind):
    """Kind `gripper`: two position actuators, each of which moves its finger by half the width."""

    name = "gripper"
    takes = "gripper"

    def declare(self, name: str, block: Block) -> GripperDeclaration | None:
        """Keys `fingers`, `width`."""
        fingers, width = block.texts("fingers", required=True), block.number("width")
        if fingers is None or width is None:
            return None
        if width <= 0:
            block.problem(f"{block.path}.width must be positive", "width")
            return None
        return GripperDeclaration(name, self.name, block.line, fingers, width)

    def bind(
        self, model: mujoco.MjModel, declarations: Sequence[DeviceDeclaration], problems: Problems
    ) -> "GripperBank":
        """Find the position actuators."""

        def fingers(declaration: DeviceDeclaration) -> _Pair:
            assert isinstance(declaration, GripperDeclaration)  # noqa: S101
            return _pair(model, declaration.fingers, ("fingers", "fingers"), "position")

        return GripperBank(find_all(declarations, problems, fingers))

    def fields(self, declaration: DeviceDeclaration) -> tuple[str, ...]:
        """Width and force."""
        return ("width", "effort")


class GripperBank:
    """All grippers of a world."""

    def __init__(self, devices: Sequence[tuple[DeviceDeclaration, _Pair]]) -> None:
        self._devices = tuple(devices)
        self._by_name = {d.name: (d, pair) for d, pair in devices}

    def read(self, model: mujoco.MjModel, data: mujoco.MjData) -> Sequence[Reading]:
        """The sum of the openings of both fingers, and the mean of their forces."""
        readings: list[Reading] = []
        for declaration, pair in self._devices:
            width = sum(data.qpos.item(joint.position) for joint in pair.joints)
            effort = sum(data.qfrc_actuator.item(joint.velocity) for joint in pair.joints) / 2
            readings.append(Reading(declaration, (width, effort)))
        return readings

    def write(self, model: mujoco.MjModel, data: mujoco.MjData, command: Command) -> None:
        """Move each finger by half the width."""
        declaration, pair = self._by_name[command.device]
        assert isinstance(declaration, GripperDeclaration)  # noqa: S101
        width = expected_form(command, "gripper")["width"]
        if not 0 <= width <= declaration.width:
            raise UnreachableValue(
                f"commands: {command.device}.width: {width:g} m is outside the limits [0, {declaration.width:g}]"
            )
        for actuator in pair.actuators:
            command_actuator(model, data, actuator, width / 2, f"{command.device}.width/2")

    def accepts(self, model: mujoco.MjModel, device: str) -> Accepted:
        """The widths that the hand and both of its fingers reach."""
        declaration, pair = self._by_name[device]
        assert isinstance(declaration, GripperDeclaration)  # noqa: S101
        lows, highs = zip(*(limits_of(model, actuator) for actuator in pair.actuators), strict=True)
        low, high = max(0.0, *(2 * low for low in lows)), min(declaration.width, *(2 * high for high in highs))
        return Accepted({"width": (low, high)})

    def actuators(self, device: str) -> tuple[int, ...]:
        """The actuators of both fingers."""
        return self._by_name[device][1].actuators
