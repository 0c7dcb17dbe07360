"""Start states: keyframes of the model."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import mujoco
import numpy as np
from numpy.typing import NDArray

from sitaf_bridge.world.description.declaration import Description
from sitaf_bridge.world.description.yaml_block import Problems
from sitaf_bridge.world.parameters.settings import NoSuchSetting
from sitaf_bridge.world.robots.fitting import START as URDF_START


@dataclass(frozen=True)
class StartState:
    """The keyframe that a session begins in: the index of one of `keys`."""

    keys: tuple[int, ...]
    edits_model: bool = False
    lowest: float = 0.0

    def column(self, batch: Any) -> NDArray[np.float64] | None:
        """Not supported."""
        return None

    def get(self, model: mujoco.MjModel, data: mujoco.MjData) -> float:
        """The keyframe with the present positions, or 0."""
        return float(next((i for i, k in enumerate(self.keys) if np.array_equal(model.key_qpos[k], data.qpos)), 0))

    def put(self, model: mujoco.MjModel, data: mujoco.MjData, value: float) -> None:
        """Enter the keyframe; numbers between two indices select the nearest."""
        enter(model, data, self.keys[round(value)])


def enter(model: mujoco.MjModel, data: mujoco.MjData, key: int) -> None:
    """Set the state of a keyframe, but not its time: time is a number of steps."""
    data.qpos[:], data.qvel[:] = model.key_qpos[key], model.key_qvel[key]
    data.act[:], data.ctrl[:] = model.key_act[key], model.key_ctrl[key]
    data.mocap_pos[:] = model.key_mpos[key].reshape(data.mocap_pos.shape)
    data.mocap_quat[:] = model.key_mquat[key].reshape(data.mocap_quat.shape)


def start_setting(model: mujoco.MjModel, choices: Sequence[str]) -> StartState:
    """The setting of the path `start`. Raises NoSuchSetting."""
    return StartState(tuple(_key(model, name) for name in choices))


def find_start(model: mujoco.MjModel, description: Description, problems: Problems) -> int | None:
    """The keyframe in which sessions begin, if not in the model's initial state."""
    if description.start is None:
        urdf = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_KEY, URDF_START)
        return None if urdf < 0 else urdf
    try:
        return _key(model, description.start)
    except NoSuchSetting as error:
        problems.add(description.start_line, f"start: {error}")
        return None


def _key(model: mujoco.MjModel, name: str) -> int:
    key = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_KEY, name)
    if key < 0:
        names = [mujoco.mj_id2name(model, mujoco.mjtObj.mjOBJ_KEY, k) for k in range(model.nkey)]
        known = ", ".join(n for n in names if n and n != URDF_START) or "none"
        raise NoSuchSetting(f"the model has no keyframe {name!r}; keyframes: {known}")
    return key
