"""Kinds `imu`, `magnetometer`, `pose` and `force_torque`: sensors at a site."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import mujoco
import numpy as np

from sitaf_bridge.world.description.yaml_block import Block, Problems
from sitaf_bridge.world.devices.binding import find, find_all
from sitaf_bridge.world.devices.kind import DeviceDeclaration, DeviceKind, Reading

SITE = mujoco.mjtObj.mjOBJ_SITE
ORIENTATION = ("orientation.x", "orientation.y", "orientation.z", "orientation.w")
Measure = Callable[[mujoco.MjModel, mujoco.MjData, int], tuple[float, ...]]


@dataclass(frozen=True)
class SiteDeclaration(DeviceDeclaration):
    """A device at a site."""

    site: str


class SiteKind(DeviceKind):
    """A kind of devices that are attached to a site and measured by one function."""

    def __init__(self, name: str, fields: tuple[str, ...], measure: Measure) -> None:
        self.name = name
        self._fields = fields
        self._measure = measure

    def declare(self, name: str, block: Block) -> SiteDeclaration | None:
        """Key `site`."""
        site = block.text("site")
        return None if site is None else SiteDeclaration(name, self.name, block.line, site)

    def bind(self, model: mujoco.MjModel, declarations: Sequence[DeviceDeclaration], problems: Problems) -> "SiteBank":
        """Find the sites."""

        def site_of(declaration: DeviceDeclaration) -> int:
            assert isinstance(declaration, SiteDeclaration)  # noqa: S101
            return find(model, "site", declaration.site)

        return SiteBank(find_all(declarations, problems, site_of), self._measure)

    def fields(self, declaration: DeviceDeclaration) -> tuple[str, ...]:
        """The fields of the kind."""
        return self._fields


class SiteBank:
    """All devices of one such kind."""

    def __init__(self, devices: Sequence[tuple[DeviceDeclaration, int]], measure: Measure) -> None:
        self._devices = tuple(devices)
        self._measure = measure

    def read(self, model: mujoco.MjModel, data: mujoco.MjData) -> Sequence[Reading]:
        """The readings at the current step."""
        return [Reading(d, self._measure(model, data, site)) for d, site in self._devices]


def orientation(matrix: object) -> tuple[float, ...]:
    """The unit quaternion x, y, z, w of a 3x3 rotation matrix, given as nine numbers."""
    q = np.empty(4)
    mujoco.mju_mat2Quat(q, matrix)
    w, x, y, z = q.tolist()
    return x, y, z, w


def _imu(model: mujoco.MjModel, data: mujoco.MjData, site: int) -> tuple[float, ...]:
    motion, force = np.empty(6), np.empty(6)
    mujoco.mj_rnePostConstraint(model, data)
    mujoco.mj_objectVelocity(model, data, SITE, site, motion, 1)
    mujoco.mj_objectAcceleration(model, data, SITE, site, force, 1)
    return (*orientation(data.site_xmat[site]), *motion[:3].tolist(), *force[3:].tolist())


def _magnetometer(model: mujoco.MjModel, data: mujoco.MjData, site: int) -> tuple[float, ...]:
    return tuple((data.site_xmat[site].reshape(3, 3).T @ model.opt.magnetic).tolist())


def _pose(_model: mujoco.MjModel, data: mujoco.MjData, site: int) -> tuple[float, ...]:
    return (*data.site_xpos[site].tolist(), *orientation(data.site_xmat[site]))


def _force_torque(model: mujoco.MjModel, data: mujoco.MjData, site: int) -> tuple[float, ...]:
    mujoco.mj_rnePostConstraint(model, data)
    body = int(model.site_bodyid[site])
    local = np.empty(6)
    centre = data.subtree_com[model.body_rootid[body]]
    mujoco.mju_transformSpatial(local, data.cfrc_int[body], 1, data.site_xpos[site], centre, data.site_xmat[site])
    return (*local[3:].tolist(), *local[:3].tolist())


def _xyz(name: str) -> tuple[str, ...]:
    return tuple(f"{name}.{axis}" for axis in "xyz")


IMU = SiteKind("imu", (*ORIENTATION, *_xyz("angular_velocity"), *_xyz("linear_acceleration")), _imu)
MAGNETOMETER = SiteKind("magnetometer", _xyz("field"), _magnetometer)
POSE = SiteKind("pose", (*_xyz("position"), *ORIENTATION), _pose)
FORCE_TORQUE = SiteKind("force_torque", (*_xyz("force"), *_xyz("torque")), _force_torque)
