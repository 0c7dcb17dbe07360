"""Settings that rotate bodies: roll, pitch and yaw in radians about fixed axes (REP-103), one at a time.

Setting one angle keeps the other two; near a pitch of 90 degrees roll and yaw are not independent.
"""

import math
from dataclasses import dataclass
from typing import Any

import mujoco
import numpy as np
from numpy.typing import NDArray


def angles_of(quaternion: NDArray[np.float64]) -> list[float]:
    """Roll, pitch, yaw of a quaternion w, x, y, z."""
    m = np.empty(9)
    mujoco.mju_quat2Mat(m, quaternion)
    return [math.atan2(m[7], m[8]), math.asin(max(-1.0, min(1.0, -m[6]))), math.atan2(m[3], m[0])]


def _turned(quaternion: NDArray[np.float64], angle: int, value: float) -> NDArray[np.float64]:
    angles = angles_of(quaternion)
    angles[angle] = value
    turned = np.empty(4)
    mujoco.mju_euler2Quat(turned, np.array(angles), "XYZ")
    return turned


@dataclass(frozen=True)
class MocapRotation:
    """An angle of a mocap body."""

    mocap: int
    angle: int
    edits_model: bool = False
    lowest: float = -np.inf

    def column(self, batch: Any) -> NDArray[np.float64] | None:
        """Not supported: the setting writes four numbers."""
        return None

    def get(self, model: mujoco.MjModel, data: mujoco.MjData) -> float:
        """From the data."""
        return angles_of(data.mocap_quat[self.mocap])[self.angle]

    def put(self, model: mujoco.MjModel, data: mujoco.MjData, value: float) -> None:
        """Into the data."""
        data.mocap_quat[self.mocap] = _turned(data.mocap_quat[self.mocap], self.angle, value)


@dataclass(frozen=True)
class FreeRotation:
    """An angle of a body with a free joint, whose quaternion starts at `address` of qpos."""

    address: int
    angle: int
    edits_model: bool = False
    lowest: float = -np.inf

    def column(self, batch: Any) -> NDArray[np.float64] | None:
        """Not supported: the setting writes four numbers."""
        return None

    def get(self, model: mujoco.MjModel, data: mujoco.MjData) -> float:
        """From the data."""
        return angles_of(data.qpos[self.address : self.address + 4])[self.angle]

    def put(self, model: mujoco.MjModel, data: mujoco.MjData, value: float) -> None:
        """Into the data."""
        part = slice(self.address, self.address + 4)
        data.qpos[part] = _turned(data.qpos[part], self.angle, value)
