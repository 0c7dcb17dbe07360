"""Kinds `joint_encoder` and `joint_motor`: sensors and drives of hinge and slide joints."""

from collections.abc import Sequence
from dataclasses import dataclass

import mujoco

from sitaf_bridge.errors import InvalidRequest
from sitaf_bridge.world.description.yaml_block import Block, Problems
from sitaf_bridge.world.devices.binding import (
    Joint,
    beyond_limits,
    find,
    find_all,
    find_single_joint,
    joint_of,
    limits_of,
    mode_of,
)
from sitaf_bridge.world.devices.kind import (
    Accepted,
    Command,
    DeviceDeclaration,
    DeviceKind,
    Limits,
    Reading,
    expected_form,
)

FIELDS = ("position", "velocity", "effort")


@dataclass(frozen=True)
class EncoderDeclaration(DeviceDeclaration):
    """`resolution` is the smallest difference that it detects, in radians or metres; 0 for exact."""

    joint: str
    resolution: float


@dataclass(frozen=True)
class MotorDeclaration(DeviceDeclaration):
    """A motor refers to an actuator of the MJCF."""

    actuator: str


@dataclass(frozen=True)
class _Motor:
    actuator: int
    joint: Joint
    mode: str
    limits: Limits


class JointEncoderKind(DeviceKind):
    """Kind `joint_encoder`."""

    name = "joint_encoder"

    def declare(self, name: str, block: Block) -> EncoderDeclaration | None:
        """Keys `joint`, `resolution`."""
        joint, resolution = block.text("joint"), block.optional_number("resolution", 0.0)
        if joint is None or resolution is None:
            return None
        if resolution < 0:
            block.problem(f"{block.path}.resolution: {resolution:g} is negative", "resolution")
            return None
        return EncoderDeclaration(name, self.name, block.line, joint, resolution)

    def bind(
        self, model: mujoco.MjModel, declarations: Sequence[DeviceDeclaration], problems: Problems
    ) -> "EncoderBank":
        """Find the joints."""

        def joint(declaration: DeviceDeclaration) -> Joint:
            assert isinstance(declaration, EncoderDeclaration)  # noqa: S101
            return find_single_joint(model, declaration.joint)

        return EncoderBank(find_all(declarations, problems, joint))

    def fields(self, declaration: DeviceDeclaration) -> tuple[str, ...]:
        """Position and velocity; an encoder measures no effort."""
        return FIELDS[:2]


class EncoderBank:
    """All encoders of a world."""

    def __init__(self, devices: Sequence[tuple[DeviceDeclaration, Joint]]) -> None:
        self._devices = tuple(devices)

    def read(self, model: mujoco.MjModel, data: mujoco.MjData) -> Sequence[Reading]:
        """Position and velocity."""
        qpos, qvel = data.qpos, data.qvel
        return [
            Reading(d, (_encoded(d, qpos.item(joint.position)), qvel.item(joint.velocity)))
            for d, joint in self._devices
        ]


def _encoded(declaration: DeviceDeclaration, position: float) -> float:
    assert isinstance(declaration, EncoderDeclaration)  # noqa: S101
    if declaration.resolution > 0:
        return round(position / declaration.resolution) * declaration.resolution
    return position


class JointMotorKind(DeviceKind):
    """Kind `joint_motor`; the type of its actuator defines whether it takes position, velocity or effort."""

    name = "joint_motor"
    takes = "joint"

    def declare(self, name: str, block: Block) -> MotorDeclaration | None:
        """Key `actuator`."""
        actuator = block.text("actuator")
        return None if actuator is None else MotorDeclaration(name, self.name, block.line, actuator)

    def bind(self, model: mujoco.MjModel, declarations: Sequence[DeviceDeclaration], problems: Problems) -> "MotorBank":
        """Find the actuators."""

        def motor(declaration: DeviceDeclaration) -> _Motor:
            assert isinstance(declaration, MotorDeclaration)  # noqa: S101
            actuator = find(model, "actuator", declaration.actuator)
            joint, mode = joint_of(model, actuator, "actuator"), mode_of(model, actuator, "actuator")
            return _Motor(actuator, joint, mode, limits_of(model, actuator))

        return MotorBank(find_all(declarations, problems, motor))

    def fields(self, declaration: DeviceDeclaration) -> tuple[str, ...]:
        """The full state of a joint."""
        return FIELDS


class MotorBank:
    """All joint motors of a world."""

    def __init__(self, devices: Sequence[tuple[DeviceDeclaration, _Motor]]) -> None:
        self._devices = tuple(devices)
        self._by_name = {d.name: motor for d, motor in devices}

    def read(self, model: mujoco.MjModel, data: mujoco.MjData) -> Sequence[Reading]:
        """Position, velocity, and the force or torque of the actuators on the joint."""
        qpos, qvel, force = data.qpos, data.qvel, data.qfrc_actuator
        return [
            Reading(d, (qpos.item(m.joint.position), qvel.item(m.joint.velocity), force.item(m.joint.velocity)))
            for d, m in self._devices
        ]

    def write(self, model: mujoco.MjModel, data: mujoco.MjData, command: Command) -> None:
        """Set the control in the mode of the actuator."""
        motor = self._by_name[command.device]
        ((mode, value),) = expected_form(command, "joint").items()
        if mode != motor.mode:
            raise InvalidRequest(f"commands: the motor {command.device} takes {motor.mode}, not {mode}")
        low, high = motor.limits
        if not low <= value <= high:
            raise beyond_limits(f"{command.device}.{mode}", value, motor.limits)
        data.ctrl[motor.actuator] = value

    def accepts(self, model: mujoco.MjModel, device: str) -> Accepted:
        """The mode of the actuator."""
        motor = self._by_name[device]
        return Accepted({motor.mode: motor.limits})

    def actuators(self, device: str) -> tuple[int, ...]:
        """The actuator of a motor."""
        return (self._by_name[device].actuator,)
