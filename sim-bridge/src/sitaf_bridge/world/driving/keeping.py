"""The whole state of a simulation at one moment, to be put back bit by bit."""

import hashlib
import struct
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import mujoco
import numpy as np
from numpy.typing import NDArray

from sitaf_bridge.world.parameters.settings import Setting
from sitaf_bridge.world.sensing.sensing import Memory
from sitaf_bridge.world.state import WorldState
from sitaf_bridge.world.world import World


@dataclass(frozen=True)
class Kept:
    """MuJoCo's integration state with the warm start, what parameters wrote to the model, and the bridge's own."""

    world: World
    state: NDArray[np.float64]
    settings: tuple[float, ...]
    values: Mapping[str, float]
    step: int
    frozen: str | None
    memory: Memory


@dataclass(frozen=True)
class Begun:
    """What a session begins with: all of MuJoCo's data, what is seen of it, and what parameters wrote to the model."""

    data: mujoco.MjData
    state: WorldState
    settings: tuple[float, ...]

    def put_back(self, model: mujoco.MjModel, data: mujoco.MjData, settings: Sequence[Setting]) -> None:
        """Make a model of the same world, and its data, what they were."""
        for setting, value in zip(settings, self.settings, strict=True):
            setting.put(model, data, value)
        # After the settings, some of which leave traces in the data.
        mujoco.mj_copyData(data, model, self.data)


def digest_of(kept: Kept, seen: WorldState, before: bytes = b"") -> bytes:
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
