"""The quantities that a world's parameters may set: what stands behind the `set` paths of a description."""

import re
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Protocol

import mujoco
import numpy as np

from sitaf_bridge.world.geometry.geom_bounds import refit

AXES = "xyz"
INTEGRATION = int(mujoco.mjtState.mjSTATE_INTEGRATION)


class Setting(Protocol):
    """One settable number of a model or its data, in SI units. Holds no state of a session."""

    @property
    def edits_model(self) -> bool:
        """Whether it writes to the model; a session then needs one of its own."""
        ...

    @property
    def lowest(self) -> float:
        """The smallest value that makes sense, inclusive."""
        ...

    def get(self, model: mujoco.MjModel, data: mujoco.MjData) -> float:
        """The present value."""
        ...

    def put(self, model: mujoco.MjModel, data: mujoco.MjData, value: float) -> None:
        """Set the value. What follows from it (`mj_kinematics`, `mj_forward`) is left to the caller."""
        ...


@dataclass(frozen=True)
class MocapPosition:
    """A coordinate of a mocap body, in metres."""

    mocap: int
    axis: int
    edits_model: bool = False
    lowest: float = -np.inf

    def get(self, model: mujoco.MjModel, data: mujoco.MjData) -> float:
        """From the data."""
        return float(data.mocap_pos[self.mocap, self.axis])

    def put(self, model: mujoco.MjModel, data: mujoco.MjData, value: float) -> None:
        """Into the data."""
        data.mocap_pos[self.mocap, self.axis] = value


@dataclass(frozen=True)
class JointPosition:
    """An entry of qpos: a hinge in radians, a slide in metres, or a coordinate of a free body."""

    address: int
    edits_model: bool = False
    lowest: float = -np.inf

    def get(self, model: mujoco.MjModel, data: mujoco.MjData) -> float:
        """From the data."""
        return float(data.qpos[self.address])

    def put(self, model: mujoco.MjModel, data: mujoco.MjData, value: float) -> None:
        """Into the data."""
        data.qpos[self.address] = value


@dataclass(frozen=True)
class BodyPosition:
    """Where a body is fixed in its parent, in metres. `moves`: it or a body below it has degrees of freedom."""

    body: int
    axis: int
    moves: bool
    edits_model: bool = True
    lowest: float = -np.inf

    def get(self, model: mujoco.MjModel, data: mujoco.MjData) -> float:
        """From the model."""
        return float(model.body_pos[self.body, self.axis])

    def put(self, model: mujoco.MjModel, data: mujoco.MjData, value: float) -> None:
        """Into the model, and with it the constants that depend on the arrangement of the bodies."""
        model.body_pos[self.body, self.axis] = value
        if self.moves:
            _derive_constants(model, data)


@dataclass(frozen=True)
class BodyMass:
    """The mass of a body in kilograms; its inertia is scaled along, as of a body of another density."""

    body: int
    mass: float
    inertia: tuple[float, float, float]
    edits_model: bool = True
    lowest: float = float(mujoco.mjMINVAL)

    def get(self, model: mujoco.MjModel, data: mujoco.MjData) -> float:
        """From the model."""
        return float(model.body_mass[self.body])

    def put(self, model: mujoco.MjModel, data: mujoco.MjData, value: float) -> None:
        """Scaled from the compiled values, so that setting back restores every bit."""
        model.body_mass[self.body] = value
        model.body_inertia[self.body] = np.array(self.inertia) * (value / self.mass)
        _derive_constants(model, data)


@dataclass(frozen=True)
class GeomFriction:
    """A friction coefficient of a geom: 0 sliding (1), 1 torsional (m), 2 rolling (m)."""

    geom: int
    index: int
    edits_model: bool = True
    lowest: float = 0.0

    def get(self, model: mujoco.MjModel, data: mujoco.MjData) -> float:
        """From the model."""
        return float(model.geom_friction[self.geom, self.index])

    def put(self, model: mujoco.MjModel, data: mujoco.MjData, value: float) -> None:
        """Into the model."""
        model.geom_friction[self.geom, self.index] = value


@dataclass(frozen=True)
class GeomSize:
    """A size of a primitive geom in metres; its mass stays."""

    geom: int
    index: int
    edits_model: bool = True
    lowest: float = float(mujoco.mjMINVAL)

    def get(self, model: mujoco.MjModel, data: mujoco.MjData) -> float:
        """From the model."""
        return float(model.geom_size[self.geom, self.index])

    def put(self, model: mujoco.MjModel, data: mujoco.MjData, value: float) -> None:
        """Into the model, and with it the bounds by which rays and contacts are found."""
        model.geom_size[self.geom, self.index] = value
        refit(model, self.geom)


@dataclass(frozen=True)
class Gravity:
    """A component of gravity in metres per second squared."""

    axis: int
    edits_model: bool = True
    lowest: float = -np.inf

    def get(self, model: mujoco.MjModel, data: mujoco.MjData) -> float:
        """From the model."""
        return float(model.opt.gravity[self.axis])

    def put(self, model: mujoco.MjModel, data: mujoco.MjData, value: float) -> None:
        """Into the model."""
        model.opt.gravity[self.axis] = value


def _derive_constants(model: mujoco.MjModel, data: mujoco.MjData) -> None:
    """mj_setConst, which computes in the data, without a trace in the data's state."""
    state = np.empty(mujoco.mj_stateSize(model, INTEGRATION))
    mujoco.mj_getState(model, data, state, INTEGRATION)
    mujoco.mj_setConst(model, data)
    mujoco.mj_setState(model, data, state, INTEGRATION)


class NoSuchSetting(Exception):
    """A path that is not one, or that the model does not have; its text completes `set: PATH: ...`."""


@dataclass(frozen=True)
class _Form:
    shape: str
    find: Callable[[mujoco.MjModel, str, str], Setting]
    pattern: re.Pattern[str] = field(compare=False)


def find_setting(model: mujoco.MjModel, path: str) -> Setting:
    """The setting that a `set` path names. Raises NoSuchSetting."""
    for form in FORMS:
        match = form.pattern.fullmatch(path)
        if match:
            return form.find(model, match["name"], match["last"])
    raise NoSuchSetting("is not a path that can be set; known forms: " + ", ".join(form.shape for form in FORMS))


def name_to_id(model: mujoco.MjModel, kind: mujoco.mjtObj, noun: str, name: str) -> int:
    """The id of a named element. Raises NoSuchSetting."""
    found = mujoco.mj_name2id(model, kind, name)
    if found < 0:
        raise NoSuchSetting(f"the MJCF has no {noun} {name!r}")
    return found


def _body_position(model: mujoco.MjModel, name: str, last: str) -> Setting:
    body = name_to_id(model, mujoco.mjtObj.mjOBJ_BODY, "body", name)
    axis = AXES.index(last)
    if body == 0:
        raise NoSuchSetting("the world itself cannot be moved")
    if model.body_mocapid[body] >= 0:
        return MocapPosition(int(model.body_mocapid[body]), axis)
    joint = int(model.body_jntadr[body])
    if joint >= 0 and model.jnt_type[joint] == mujoco.mjtJoint.mjJNT_FREE:
        return JointPosition(int(model.jnt_qposadr[joint]) + axis)
    moves = bool(model.body_weldid[body] != 0) or any(
        model.body_dofnum[b] > 0 and _is_below(model, b, body) for b in range(body, model.nbody)
    )
    return BodyPosition(body, axis, moves)


def _is_below(model: mujoco.MjModel, body: int, ancestor: int) -> bool:
    while body > ancestor:
        body = int(model.body_parentid[body])
    return body == ancestor


def _body_mass(model: mujoco.MjModel, name: str, _last: str) -> Setting:
    body = name_to_id(model, mujoco.mjtObj.mjOBJ_BODY, "body", name)
    mass = float(model.body_mass[body])
    if mass <= 0:
        raise NoSuchSetting(f"the body {name!r} has no mass, so there is no inertia to scale")
    x, y, z = model.body_inertia[body].tolist()
    return BodyMass(body, mass, (x, y, z))


def _geom_friction(model: mujoco.MjModel, name: str, last: str) -> Setting:
    return GeomFriction(name_to_id(model, mujoco.mjtObj.mjOBJ_GEOM, "geom", name), int(last))


def _geom_size(model: mujoco.MjModel, name: str, last: str) -> Setting:
    geom = name_to_id(model, mujoco.mjtObj.mjOBJ_GEOM, "geom", name)
    kind = mujoco.mjtGeom(int(model.geom_type[geom]))
    sizes = {
        mujoco.mjtGeom.mjGEOM_SPHERE: 1,
        mujoco.mjtGeom.mjGEOM_CAPSULE: 2,
        mujoco.mjtGeom.mjGEOM_CYLINDER: 2,
        mujoco.mjtGeom.mjGEOM_ELLIPSOID: 3,
        mujoco.mjtGeom.mjGEOM_BOX: 3,
    }.get(kind, 0)
    if int(last) >= sizes:
        raise NoSuchSetting(f"the geom {name!r} has {sizes} sizes that can be set")
    return GeomSize(geom, int(last))


def _joint_position(model: mujoco.MjModel, name: str, _last: str) -> Setting:
    joint = name_to_id(model, mujoco.mjtObj.mjOBJ_JOINT, "joint", name)
    # Converted, because MuJoCo's enumerators do not equal NumPy's integers from their own side.
    if mujoco.mjtJoint(int(model.jnt_type[joint])) not in (mujoco.mjtJoint.mjJNT_HINGE, mujoco.mjtJoint.mjJNT_SLIDE):
        raise NoSuchSetting(f"the joint {name!r} is neither a hinge nor a slide")
    return JointPosition(int(model.jnt_qposadr[joint]))


def _gravity(_model: mujoco.MjModel, _name: str, last: str) -> Setting:
    return Gravity(AXES.index(last))


FORMS = tuple(
    _Form(shape, find, re.compile(pattern))
    for shape, pattern, find in (
        ("body.NAME.pos.x|y|z", r"body\.(?P<name>.+)\.pos\.(?P<last>[xyz])", _body_position),
        ("body.NAME.mass", r"body\.(?P<name>.+)\.(?P<last>mass)", _body_mass),
        ("geom.NAME.friction.0|1|2", r"geom\.(?P<name>.+)\.friction\.(?P<last>[012])", _geom_friction),
        ("geom.NAME.size.0|1|2", r"geom\.(?P<name>.+)\.size\.(?P<last>[012])", _geom_size),
        ("joint.NAME.pos", r"joint\.(?P<name>.+)\.(?P<last>pos)", _joint_position),
        ("option.gravity.x|y|z", r"(?P<name>option)\.gravity\.(?P<last>[xyz])", _gravity),
    )
)
