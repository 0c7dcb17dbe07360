"""Resolves the names in device declarations: sites, joints, and the actuators that drive them."""

import math
from collections.abc import Callable, Sequence
from typing import NamedTuple, TypeVar

import mujoco

from sitaf_bridge.errors import UnreachableValue
from sitaf_bridge.world.description.yaml_block import Problems
from sitaf_bridge.world.devices.kind import DeviceDeclaration, Limits

NOUNS = {
    "site": mujoco.mjtObj.mjOBJ_SITE,
    "geom": mujoco.mjtObj.mjOBJ_GEOM,
    "joint": mujoco.mjtObj.mjOBJ_JOINT,
    "actuator": mujoco.mjtObj.mjOBJ_ACTUATOR,
    "camera": mujoco.mjtObj.mjOBJ_CAMERA,
}
Found = TypeVar("Found")


class Joint(NamedTuple):
    """A hinge or slide joint: the indices of its position and its velocity in the state of a model."""

    position: int
    velocity: int


class BindingError(Exception):
    """A device cannot be bound; the message completes `devices.NAME.KEY: ...`."""

    def __init__(self, key: str, message: str) -> None:
        self.key = key
        super().__init__(message)


def find(model: mujoco.MjModel, noun: str, name: str, key: str | None = None) -> int:
    """The id of a named element. Raises BindingError."""
    found = mujoco.mj_name2id(model, NOUNS[noun], name)
    if found < 0:
        raise BindingError(key or noun, f"the model has no {noun} {name!r}")
    return found


def find_single_joint(model: mujoco.MjModel, name: str, key: str = "joint") -> Joint:
    """A hinge or slide joint. Raises BindingError."""
    joint = find(model, "joint", name, key)
    if mujoco.mjtJoint(int(model.jnt_type[joint])) not in (mujoco.mjtJoint.mjJNT_HINGE, mujoco.mjtJoint.mjJNT_SLIDE):
        raise BindingError(key, f"the joint {name!r} is neither a hinge nor a slide")
    return Joint(int(model.jnt_qposadr[joint]), int(model.jnt_dofadr[joint]))


def find_all(
    declarations: Sequence[DeviceDeclaration], problems: Problems, bind: Callable[[DeviceDeclaration], Found]
) -> list[tuple[DeviceDeclaration, Found]]:
    """Bind each declaration and report those that cannot be bound."""
    found: list[tuple[DeviceDeclaration, Found]] = []
    for declaration in declarations:
        try:
            found.append((declaration, bind(declaration)))
        except BindingError as error:
            problems.add(declaration.line, f"devices.{declaration.name}.{error.key}: {error}")
    return found


def part_of(model: mujoco.MjModel, body: int) -> frozenset[int]:
    """The bodies that are rigidly connected to a body, such as a sensor's housing, without the world."""
    if body == 0:
        return frozenset()

    def anchor(b: int) -> int:
        while model.body_jntnum[b] == 0 and model.body_parentid[b] != 0:
            b = int(model.body_parentid[b])
        return b

    own = anchor(body)
    return frozenset(b for b in range(1, model.nbody) if anchor(b) == own)


def joint_of(model: mujoco.MjModel, actuator: int, key: str) -> Joint:
    """The hinge or slide joint that an actuator drives. Raises BindingError."""
    if mujoco.mjtTrn(int(model.actuator_trntype[actuator])) != mujoco.mjtTrn.mjTRN_JOINT:
        raise BindingError(key, "the actuator does not drive a joint")
    name = mujoco.mj_id2name(model, mujoco.mjtObj.mjOBJ_JOINT, int(model.actuator_trnid[actuator, 0]))
    return find_single_joint(model, name or "", key)


def mode_of(model: mujoco.MjModel, actuator: int, key: str) -> str:
    """The meaning of an actuator's control: position, velocity or effort. Raises BindingError."""
    bias = mujoco.mjtBias(int(model.actuator_biastype[actuator]))
    gain = float(model.actuator_gainprm[actuator, 0])
    offset, by_position, by_velocity = model.actuator_biasprm[actuator, :3].tolist()
    if mujoco.mjtGain(int(model.actuator_gaintype[actuator])) == mujoco.mjtGain.mjGAIN_FIXED:
        if bias == mujoco.mjtBias.mjBIAS_NONE:
            return "effort"
        if bias == mujoco.mjtBias.mjBIAS_AFFINE and offset == 0 and gain > 0:
            if by_position == -gain:
                return "position"
            if by_position == 0 and by_velocity == -gain:
                return "velocity"
    raise BindingError(key, "the actuator is none of <position>, <velocity>, <motor>")


def limits_of(model: mujoco.MjModel, actuator: int) -> tuple[float, float]:
    """The smallest and the largest control that `command_actuator` accepts."""
    if not model.actuator_ctrllimited[actuator]:
        return -math.inf, math.inf
    low, high = model.actuator_ctrlrange[actuator].tolist()
    return low, high


def beyond_limits(shown: str, value: float, limits: Limits) -> UnreachableValue:
    """The error of a command outside of the limits of an actuator."""
    low, high = limits
    return UnreachableValue(f"commands: {shown}: {value:g} is outside the limits [{low:g}, {high:g}]")


def command_actuator(model: mujoco.MjModel, data: mujoco.MjData, actuator: int, value: float, shown: str) -> None:
    """Set an actuator's control. Raises UnreachableValue outside of its `ctrlrange`."""
    if model.actuator_ctrllimited[actuator]:
        low, high = model.actuator_ctrlrange[actuator].tolist()
        if not low <= value <= high:
            raise beyond_limits(shown, value, (low, high))
    data.ctrl[actuator] = value
