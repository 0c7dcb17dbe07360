"""Runs many simulations in MuJoCo's own threads, for worlds with simple parameters and devices.

Results are bit-identical to Simulation.prepare; cases for which that is not certain are returned to the caller.
"""

from collections.abc import Sequence

import mujoco
import numpy as np
from mujoco.batch import Batch
from numpy.typing import NDArray

from sitaf_bridge.world.devices import DeviceDeclaration
from sitaf_bridge.world.devices.range import RangeBank
from sitaf_bridge.world.driving.divergence import FATAL
from sitaf_bridge.world.geometry.solids import PLANE
from sitaf_bridge.world.parameters.gap import BoundGap
from sitaf_bridge.world.parameters.settings import JointPosition, MocapPosition, Setting
from sitaf_bridge.world.world import World

POSITION_STAGE = int(mujoco.mjtStage.mjSTAGE_POS)
NO_STAGE = int(mujoco.mjtStage.mjSTAGE_NONE)
SECANT_STEPS = 2
# Fraction of cases below which preparing them one by one is cheaper than another pass over all.
MIN_BATCH_FRACTION = 0.02
FIRST = np.zeros(1, np.intp)


def can_batch(world: World, devices: Sequence[DeviceDeclaration]) -> bool:
    """Whether a batch can prepare cases of this world and read these devices."""
    if any(d.noise or d.delay for d in world.description.devices.values()) or world.entities or world.start is not None:
        return False
    if any(d.kind != "range" for d in devices):
        return False
    bank = world.banks.get("range")
    if isinstance(bank, RangeBank) and not bank.native:
        return False
    if any(observation.place is None for observation in world.observations.values()):
        return False
    binds = [bind for bound in world.binds.values() for bind in bound]
    return all(
        # Different models per simulation make each step slower, so models are copied only if necessary.
        isinstance(b.setting, MocapPosition | JointPosition)
        for b in binds
    ) and all(world.model.geom_type[b.gap.geom] == PLANE for b in binds if b.gap is not None)


class BatchRun:
    """Buffers for up to `size` cases. Not thread-safe."""

    def __init__(
        self, world: World, devices: Sequence[DeviceDeclaration], names: Sequence[str], size: int, threads: int
    ) -> None:
        self._world = world
        self._names = tuple(names)
        self._devices = {d.name for d in devices}
        self._batch = Batch(world.model, size, threads)
        # Values that are bound later are zero until the next call.
        for name in ("site_xpos", "site_xmat", "geom_xpos", "geom_xmat", "sensordata", "xpos"):
            self._batch.bind(name)
        self._size = size
        # Whether derived quantities are up to date; whether all simulations are in the same state.
        self._fresh = False
        self._alike = True

    def prepare(self, values: NDArray[np.float64], steps: int, out: NDArray[np.float64]) -> list[int]:
        """Fill `out` with the readings of each case; returns the rows that must be prepared in another way."""
        count = len(values)
        ids = None if count == self._size else np.arange(count)
        batch = self._batch
        batch.warning[:] = 0
        batch.reset(ids, stage=NO_STAGE)
        odd = np.zeros(count, np.bool_)
        targets = {
            name: values[:, self._names.index(name)]
            if name in self._names
            else np.full(count, self._world.description.parameters[name].default)
            for name in self._world.binds
        }
        self._fresh, self._alike = False, True
        bound = [(name, bind) for name, binds in self._world.binds.items() for bind in binds]
        for name, bind in bound:
            if bind.gap is None:
                self._column(bind.setting)[:count] = targets[name]
                self._alike &= name not in self._names
        for name, bind in bound:
            if bind.gap is not None:
                odd |= self._solve(bind.gap, bind.setting, targets[name], ids, count)
                self._alike &= name not in self._names
        if steps:
            batch.step(ids, nstep=steps, stage=POSITION_STAGE)
        elif not self._fresh:
            batch.forward(ids, stage=POSITION_STAGE)
        odd |= batch.warning[:count, FATAL].reshape(count, -1).any(axis=1)
        self._read(count, out, odd)
        return np.flatnonzero(odd).tolist()

    def _solve(
        self, gap: BoundGap, setting: Setting, target: NDArray[np.float64], ids: NDArray[np.intp] | None, count: int
    ) -> NDArray[np.bool_]:
        """Solve the setting such that the clearance equals the target; returns the rows that failed."""
        column = self._column(setting)
        at = column[:count].copy()
        guess, missed = at, np.ones(count, np.bool_)
        if gap.offset is not None:
            guess = target + gap.offset
            column[:count] = guess
            missed = self._clearance(gap, ids, count) != target
            self._fresh = True
            if missed.mean() < MIN_BATCH_FRACTION:
                # The scalar search, which gets these few rows, corrects the last bits.
                return missed
            column[:count] = at
        # While all simulations are equal, one of them is computed for all.
        error = (self._clearance(gap, FIRST, 1) if self._alike else self._clearance(gap, ids, count)) - target
        self._fresh = not self._alike
        slope = np.ones(count)
        for _ in range(SECANT_STEPS):
            going = error != 0
            if not going.any():
                break
            following = np.where(going, at - error / slope, at)
            column[:count] = following
            after = self._clearance(gap, ids, count) - target
            self._fresh = True
            with np.errstate(divide="ignore", invalid="ignore"):
                slope = np.where(going, (after - error) / (following - at), slope)
            at, error = following, after
        column[:count] = np.where(missed, column[:count], guess)
        self._fresh &= bool(missed.all())
        return missed & ~(error == 0)

    def _column(self, setting: Setting) -> NDArray[np.float64]:
        column = setting.column(self._batch)
        assert column is not None  # noqa: S101  # by can_batch
        return column

    def _clearance(self, gap: BoundGap, ids: NDArray[np.intp] | None, count: int) -> NDArray[np.float64]:
        """The clearance along the site's z axis to a plane; NaN unless it needs a single rounded subtraction."""
        batch = self._batch
        batch.forward(ids, stage=POSITION_STAGE)
        origin, along = batch.bind("site_xpos")[:count, gap.site], batch.bind("site_xmat")[:count, gap.site, 2::3]
        centre = batch.bind("geom_xpos")[:count, gap.geom]
        axes = batch.bind("geom_xmat")[:count, gap.geom].reshape(count, 3, 3)
        exact = (np.isin(axes, (-1.0, 0.0, 1.0)).all(axis=(1, 2))) & np.isin(along, (-1.0, 0.0, 1.0)).all(axis=1)
        relative = origin - centre
        x, y, height = (
            relative[:, 0] * axes[:, 0, i] + relative[:, 1] * axes[:, 1, i] + relative[:, 2] * axes[:, 2, i]
            for i in range(3)
        )
        towards = (along * axes[:, :, 2]).sum(axis=1)
        size = self._world.model.geom_size[gap.geom]
        for across, half in ((x, size[0]), (y, size[1])):
            # The rays are perpendicular to the plane.
            exact &= (half <= 0) | (np.abs(across) <= half)
        return np.where(exact & (towards == -1.0), height, np.nan)

    def _read(self, count: int, out: NDArray[np.float64], odd: NDArray[np.bool_]) -> None:
        filled = 0
        bank = self._world.banks.get("range")
        if isinstance(bank, RangeBank) and self._devices:
            distances, unsure = bank.read_many(self._world.model, self._batch, count)
            odd |= unsure
            for column, device in enumerate(bank.devices):
                if device.name in self._devices:
                    out[:, filled] = distances[:, column]
                    filled += 1
        positions = self._batch.bind("xpos")
        for observation in self._world.observations.values():
            assert observation.place is not None  # noqa: S101  # by can_batch
            body, axis = observation.place
            out[:, filled] = positions[:count, body, axis]
            filled += 1
