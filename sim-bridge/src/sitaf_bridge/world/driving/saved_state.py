"""Saves and restores the complete state of a simulation, bit by bit."""

import hashlib
import struct
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import mujoco
import numpy as np
from numpy.typing import NDArray

from sitaf_bridge.world.devices import Command
from sitaf_bridge.world.parameters.settings import Setting
from sitaf_bridge.world.sensing.sensing import Memory
from sitaf_bridge.world.state import WorldState
from sitaf_bridge.world.world import World


@dataclass(frozen=True)
class SavedState:
    """MuJoCo's integration state with warm start, the model edits of parameters, and the bridge's own state."""

    world: World
    state: NDArray[np.float64]
    settings: tuple[float, ...]
    values: Mapping[str, float]
    step: int
    frozen: str | None
    memory: Memory
    followed: Mapping[str, Command]


@dataclass(frozen=True)
class InitialState:
    """The initial state of a session: all of MuJoCo's data, the observed state, and the model edits of parameters."""

    data: mujoco.MjData
    state: WorldState
    settings: tuple[float, ...]

    def restore(self, model: mujoco.MjModel, data: mujoco.MjData, settings: Sequence[Setting]) -> None:
        """Restore a model of the same world and its data."""
        for setting, value in zip(settings, self.settings, strict=True):
            setting.put(model, data, value)
        # After the settings, some of which modify the data.
        mujoco.mj_copyData(data, model, self.data)


def digest_of(kept: SavedState, seen: WorldState, before: bytes = b"") -> bytes:
    """SHA-256 over a state and what the devices read in it, chained to an earlier digest."""
    sha = hashlib.sha256(before)
    sha.update(struct.pack(">q", kept.step))
    sha.update(kept.state.astype("<f8").tobytes())
    sha.update(np.array(kept.settings, "<f8").tobytes())
    for name in sorted(kept.values):
        sha.update(name.encode() + b"\0" + struct.pack("<d", kept.values[name]))
    for reading in seen.readings:
        sha.update(reading.device.name.encode() + b"\0" + np.array(reading.values, "<f8").tobytes())
    sha.update(np.array(list(seen.observations.values()), "<f8").tobytes())
    return sha.digest()
