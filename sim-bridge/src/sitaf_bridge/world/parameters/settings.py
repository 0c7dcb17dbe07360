"""The quantities that parameters can set, one class per kind of `set` path."""

from dataclasses import dataclass
from typing import Any, Protocol

import mujoco
import numpy as np
from numpy.typing import NDArray

from sitaf_bridge.world.geometry.geom_bounds import refit

INTEGRATION = int(mujoco.mjtState.mjSTATE_INTEGRATION)


class Setting(Protocol):
    """One settable number of a model or its data, in SI units. Holds no state of a session."""

    @property
    def edits_model(self) -> bool:
        """Whether it writes to the model; a session then needs its own copy."""
        ...

    @property
    def lowest(self) -> float:
        """The smallest valid value, inclusive."""
        ...

    def get(self, model: mujoco.MjModel, data: mujoco.MjData) -> float:
        """The present value."""
        ...

    def column(self, batch: Any) -> NDArray[np.float64] | None:
        """The writable numbers of all simulations of a `mujoco.batch.Batch`; None if not supported."""
        ...

    def put(self, model: mujoco.MjModel, data: mujoco.MjData, value: float) -> None:
        """Set the value. The caller updates derived quantities (`mj_kinematics`, `mj_forward`)."""
        ...


@dataclass(frozen=True)
class MocapPosition:
    """A coordinate of a mocap body, in metres."""

    mocap: int
    axis: int
    edits_model: bool = False
    lowest: float = -np.inf

    def column(self, batch: Any) -> NDArray[np.float64] | None:
        """As in the data or model of each."""
        return batch.bind("mocap_pos")[:, self.mocap, self.axis]

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

    def column(self, batch: Any) -> NDArray[np.float64] | None:
        """As in the data or model of each."""
        return batch.bind("qpos")[:, self.address]

    def get(self, model: mujoco.MjModel, data: mujoco.MjData) -> float:
        """From the data."""
        return float(data.qpos[self.address])

    def put(self, model: mujoco.MjModel, data: mujoco.MjData, value: float) -> None:
        """Into the data."""
        data.qpos[self.address] = value


@dataclass(frozen=True)
class BodyPosition:
    """The position of a body in its parent, in metres. `moves`: it or a descendant has degrees of freedom."""

    body: int
    axis: int
    moves: bool
    edits_model: bool = True
    lowest: float = -np.inf

    def column(self, batch: Any) -> NDArray[np.float64] | None:
        """As in the data or model of each."""
        return None if self.moves else batch.expand("body_pos")[:, self.body, self.axis]

    def get(self, model: mujoco.MjModel, data: mujoco.MjData) -> float:
        """From the model."""
        return float(model.body_pos[self.body, self.axis])

    def put(self, model: mujoco.MjModel, data: mujoco.MjData, value: float) -> None:
        """Set it in the model, and update the constants that depend on body positions."""
        model.body_pos[self.body, self.axis] = value
        if self.moves:
            derive_constants(model, data)


@dataclass(frozen=True)
class BodyMass:
    """The mass of a body in kilograms; its inertia is scaled in proportion."""

    body: int
    mass: float
    inertia: tuple[float, float, float]
    edits_model: bool = True
    lowest: float = float(mujoco.mjMINVAL)

    def column(self, batch: Any) -> NDArray[np.float64] | None:
        """As in the data or model of each."""
        return None

    def get(self, model: mujoco.MjModel, data: mujoco.MjData) -> float:
        """From the model."""
        return float(model.body_mass[self.body])

    def put(self, model: mujoco.MjModel, data: mujoco.MjData, value: float) -> None:
        """Scale the compiled values, so that restoring is exact to the bit."""
        model.body_mass[self.body] = value
        model.body_inertia[self.body] = np.array(self.inertia) * (value / self.mass)
        derive_constants(model, data)


@dataclass(frozen=True)
class GeomFriction:
    """A friction coefficient of a geom: 0 sliding (1), 1 torsional (m), 2 rolling (m)."""

    geom: int
    index: int
    edits_model: bool = True
    lowest: float = 0.0

    def column(self, batch: Any) -> NDArray[np.float64] | None:
        """As in the data or model of each."""
        return batch.expand("geom_friction")[:, self.geom, self.index]

    def get(self, model: mujoco.MjModel, data: mujoco.MjData) -> float:
        """From the model."""
        return float(model.geom_friction[self.geom, self.index])

    def put(self, model: mujoco.MjModel, data: mujoco.MjData, value: float) -> None:
        """Into the model."""
        model.geom_friction[self.geom, self.index] = value


@dataclass(frozen=True)
class GeomSize:
    """A size of a primitive geom in metres; its mass is not changed."""

    geom: int
    index: int
    edits_model: bool = True
    lowest: float = float(mujoco.mjMINVAL)

    def column(self, batch: Any) -> NDArray[np.float64] | None:
        """As in the data or model of each."""
        return None

    def get(self, model: mujoco.MjModel, data: mujoco.MjData) -> float:
        """From the model."""
        return float(model.geom_size[self.geom, self.index])

    def put(self, model: mujoco.MjModel, data: mujoco.MjData, value: float) -> None:
        """Set it in the model, and update the bounds for rays and contacts."""
        model.geom_size[self.geom, self.index] = value
        refit(model, self.geom)


@dataclass(frozen=True)
class Gravity:
    """A component of gravity in metres per second squared."""

    axis: int
    edits_model: bool = True
    lowest: float = -np.inf

    def column(self, batch: Any) -> NDArray[np.float64] | None:
        """As in the data or model of each."""
        return batch.expand("opt.gravity")[:, self.axis]

    def get(self, model: mujoco.MjModel, data: mujoco.MjData) -> float:
        """From the model."""
        return float(model.opt.gravity[self.axis])

    def put(self, model: mujoco.MjModel, data: mujoco.MjData, value: float) -> None:
        """Into the model."""
        model.opt.gravity[self.axis] = value


def derive_constants(model: mujoco.MjModel, data: mujoco.MjData) -> None:
    """Call mj_setConst, which modifies the data, and restore the data's state."""
    state = np.empty(mujoco.mj_stateSize(model, INTEGRATION))
    mujoco.mj_getState(model, data, state, INTEGRATION)
    mujoco.mj_setConst(model, data)
    mujoco.mj_setState(model, data, state, INTEGRATION)


class NoSuchSetting(Exception):
    """An unknown path, or one that the model does not have; the message completes `set: PATH: ...`."""


def name_to_id(model: mujoco.MjModel, kind: mujoco.mjtObj, noun: str, name: str) -> int:
    """The id of a named element. Raises NoSuchSetting."""
    found = mujoco.mj_name2id(model, kind, name)
    if found < 0:
        raise NoSuchSetting(f"the MJCF has no {noun} {name!r}")
    return found
