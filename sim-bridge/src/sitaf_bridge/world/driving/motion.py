"""Records poses of bodies and readings of devices while time advances, and exports them as an animated scene."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import chain

import mujoco
import numpy as np
from numpy.typing import NDArray

from sitaf_bridge.world.description.observation import DeviceNumber
from sitaf_bridge.world.devices import KINDS, Reading
from sitaf_bridge.world.scene.drawing import Stage, body_name
from sitaf_bridge.world.scene.glb import Glb
from sitaf_bridge.world.state import WorldState
from sitaf_bridge.world.world import World

MAX_FRAMES = 2_000
MAX_BYTES = 32 * 1024 * 1024
# Position and quaternion as float32.
POSE_BYTES = 28
# Devices with more numbers, such as laser scans, would dominate the size of a recording.
MAX_NUMBERS_PER_DEVICE = 32


@dataclass(frozen=True)
class Frame:
    """Poses (bodies, 7) as position and quaternion x, y, z, w, of the bodies in `names`; readings as in `columns`."""

    step: int
    names: tuple[str, ...]
    poses: NDArray[np.float32]
    numbers: tuple[float, ...]


class MotionRecording:
    """Frames of one session, `interval` steps apart, starting with the current one.

    `omitted_kinds` are the kinds of devices that are not recorded.
    """

    def __init__(self, interval: int, most: int, world: World) -> None:
        self.omitted_kinds = _omitted_kinds(world)
        room = MAX_BYTES // (POSE_BYTES * max(1, int(world.model.nbody)))
        self._most = max(2, min(most or MAX_FRAMES, room))
        self._asked = interval
        self._names: tuple[World, tuple[str, ...]] | None = None
        self._stage: Stage | None = None
        self.restart()

    def restart(self) -> None:
        """Delete all frames."""
        self._interval = self._asked
        self._begin: int | None = None
        self._frames: list[Frame] = []

    def steps_to_next(self, step: int) -> int:
        """The number of steps until the next frame."""
        since = step - (self._begin if self._begin is not None else step)
        return self._interval - since % self._interval

    def is_due(self, step: int) -> bool:
        """Whether a frame must be recorded now."""
        return self.steps_to_next(step) == self._interval

    def record(self, world: World, data: mujoco.MjData, state: WorldState) -> None:
        """Record a state if it is due, or if it changed since it was recorded."""
        # After a reset, frames with a later time are removed.
        while self._frames and self._frames[-1].step >= state.step:
            self._frames.pop()
        if not self._frames:
            self._begin = state.step
        elif (state.step - (self._begin or 0)) % self._interval:
            return
        self._frames.append(self._frame(world, data, state))
        if len(self._frames) > self._most:
            del self._frames[1::2]
            self._interval *= 2

    def take(self, world: World, model: mujoco.MjModel, data: mujoco.MjData, state: WorldState) -> tuple[bytes, int]:
        """Export the recording and start it again with this state. Raises LimitReached."""
        taken = self.export(world, model, data, state)
        self.restart()
        self.record(world, data, state)
        return taken

    def export(self, world: World, model: mujoco.MjModel, data: mujoco.MjData, state: WorldState) -> tuple[bytes, int]:
        """Export the recording, ending with this state, as GLB, and its number of frames. Raises LimitReached."""
        frames = [frame for frame in self._frames if frame.step < state.step]
        frames.append(self._frame(world, data, state))
        if self._stage is None or not self._stage.shows(world, model):
            self._stage = Stage(world, model)
        glb, nodes = self._stage.at(data)
        seconds = np.array([frame.step * world.timestep_ns / 1e9 for frame in frames], np.float32)
        if len(frames) > 1:
            _animate(glb, nodes, frames, seconds)
        glb.extras["readings"] = {
            "columns": columns(world),
            "times": glb.view(seconds),
            "rows": glb.view(np.array([frame.numbers for frame in frames], np.float32)),
        }
        return glb.content(), len(frames)

    def _frame(self, world: World, data: mujoco.MjData, state: WorldState) -> Frame:
        if self._names is None or self._names[0] is not world:
            self._names = world, tuple(body_name(world.model, body) for body in range(world.model.nbody))
        poses = np.empty((len(self._names[1]), 7), np.float32)
        poses[:, :3] = data.xpos
        poses[:, 3:6] = data.xquat[:, 1:]
        poses[:, 6] = data.xquat[:, 0]
        return Frame(state.step, self._names[1], poses, _numbers(state.readings, state))


def columns(world: World) -> list[str]:
    """The names of the numbers in a frame."""
    devices = [d for d in world.description.devices.values() if not KINDS[d.kind].image]
    fields = [(d.name, KINDS[d.kind].fields(d)) for d in devices]
    shown = [f"{name}.{field}" for name, names in fields if len(names) <= MAX_NUMBERS_PER_DEVICE for field in names]
    return [*shown, *world.description.observations]


def _omitted_kinds(world: World) -> frozenset[str]:
    devices = [d for d in world.description.devices.values() if not KINDS[d.kind].image]
    observed = {o.sight.device for o in world.description.observations.values() if isinstance(o.sight, DeviceNumber)}
    shown = {d.kind for d in devices if d.name in observed or len(KINDS[d.kind].fields(d)) <= MAX_NUMBERS_PER_DEVICE}
    return frozenset(d.kind for d in devices) - shown


def _numbers(readings: Sequence[Reading], state: WorldState) -> tuple[float, ...]:
    shown = (reading.values for reading in readings if len(reading.values) <= MAX_NUMBERS_PER_DEVICE)
    return (*chain.from_iterable(shown), *state.observations.values())


def _animate(glb: Glb, nodes: Sequence[int], frames: Sequence[Frame], seconds: NDArray[np.float32]) -> None:
    """Animate the bodies that moved. Bodies that were removed or added keep their last pose."""
    last = frames[-1]
    always = set(last.names).intersection(*(frame.names for frame in frames))
    times = glb.accessor(seconds)
    samplers: list[dict[str, object]] = []
    channels: list[dict[str, object]] = []

    def channel(node: int, path: str, values: NDArray[np.float32]) -> None:
        if (values == values[0]).all():
            glb.entry("nodes", node)[path] = values[0].tolist()
            return
        samplers.append({"input": times, "output": glb.accessor(values), "interpolation": "LINEAR"})
        channels.append({"sampler": len(samplers) - 1, "target": {"node": node, "path": path}})

    alike = all(frame.names is last.names or frame.names == last.names for frame in frames)
    together = np.stack([frame.poses for frame in frames]) if alike else None
    for body, name in enumerate(last.names):
        if body == 0 or name not in always:
            continue
        poses = together[:, body] if together is not None else np.stack([f.poses[f.names.index(name)] for f in frames])
        channel(nodes[body], "translation", np.ascontiguousarray(poses[:, :3]))
        channel(nodes[body], "rotation", _continuous(poses[:, 3:]))
    if channels:
        glb.add("animations", name="case", samplers=samplers, channels=channels)


def _continuous(quaternions: NDArray[np.float32]) -> NDArray[np.float32]:
    """Choose the sign of each quaternion that is nearer to the previous one."""
    turns = np.sum(quaternions[1:] * quaternions[:-1], axis=1) < 0
    signs = np.where(np.concatenate([[False], np.cumsum(turns) % 2 == 1]), -1, 1)
    return np.ascontiguousarray(quaternions * signs[:, None].astype(np.float32))
