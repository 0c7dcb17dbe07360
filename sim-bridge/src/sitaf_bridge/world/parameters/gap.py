"""Solves a setting such that a sensor's clearance to a surface equals a value, to the bit if possible."""

import itertools
import math
from collections.abc import Iterator
from dataclasses import dataclass, replace

import mujoco
import numpy as np

from sitaf_bridge.errors import UnreachableValue
from sitaf_bridge.world.description.declaration import Gap
from sitaf_bridge.world.geometry.solids import HFIELD, SOLID_TYPES, clearance
from sitaf_bridge.world.parameters.settings import NoSuchSetting, Setting, name_to_id

MAX_ITERATIONS = 60
# Metres. A solution with a larger error is rejected.
TOLERANCE = 1e-9
# Number of adjacent floats to try on either side of a solution.
NEIGHBOURS = 16


@dataclass(frozen=True)
class BoundGap:
    """The signed clearance in metres from a site along its z axis to where that line enters a geom."""

    site: int
    geom: int
    text: str
    # Difference of setting and clearance in the initial world: a first guess, often an exact one. Independent of
    # earlier calls, so that the same calls give the same bits.
    offset: float | None = None

    def measure(self, model: mujoco.MjModel, data: mujoco.MjData) -> float | None:
        """The current clearance, or None if the line does not enter the geom."""
        mujoco.mj_kinematics(model, data)
        along = np.ascontiguousarray(data.site_xmat[self.site].reshape(3, 3)[:, 2])
        return clearance(model, data, self.geom, data.site_xpos[self.site], along)

    def solve(self, model: mujoco.MjModel, data: mujoco.MjData, setting: Setting, target: float) -> float:
        """Solve the setting such that the clearance equals the target, and return it. Raises UnreachableValue."""
        search = _Search(self, model, data, setting, target)
        if self.offset is not None:
            began, guess = setting.get(model, data), target + self.offset
            if search.error(guess) == 0.0:
                return guess
            setting.put(model, data, began)
        best = search.polish(search.approach())
        error = search.error(best)
        if error is None or abs(error) > TOLERANCE:
            raise UnreachableValue(f"the nearest possible clearance for {self.text} has an error of {error} m")
        return best


def find_gap(model: mujoco.MjModel, gap: Gap, setting: Setting) -> BoundGap:
    """Bind a declared gap to a model. Raises NoSuchSetting."""
    site = name_to_id(model, mujoco.mjtObj.mjOBJ_SITE, "site", gap.site)
    geom = name_to_id(model, mujoco.mjtObj.mjOBJ_GEOM, "geom", gap.geom)
    if model.geom_type[geom] not in (*SOLID_TYPES, HFIELD):
        raise NoSuchSetting(f"the geom {gap.geom!r} has a type that rays cannot measure")
    bound = BoundGap(site, geom, f"gap [site.{gap.site}, geom.{gap.geom}]")
    data = mujoco.MjData(model)
    clear = bound.measure(model, data)
    return bound if clear is None else replace(bound, offset=setting.get(model, data) - clear)


class _Search:
    """A secant search: exact after two steps if the surface moves straight along the line."""

    def __init__(
        self, gap: BoundGap, model: mujoco.MjModel, data: mujoco.MjData, setting: Setting, target: float
    ) -> None:
        self.gap = gap
        self.model = model
        self.data = data
        self.setting = setting
        self.target = target

    def error(self, value: float) -> float | None:
        """The clearance at a value minus the target."""
        if not math.isfinite(value) or value < self.setting.lowest:
            return None
        self.setting.put(self.model, self.data, value)
        measured = self.gap.measure(self.model, self.data)
        return None if measured is None else measured - self.target

    def approach(self) -> float:
        """The value with the smallest error that the secant search finds."""
        at = self.setting.get(self.model, self.data)
        error = self.error(at)
        if error is None:
            raise UnreachableValue(f"the line of {self.gap.text} does not enter the geom")
        slope = 1.0
        for _ in range(MAX_ITERATIONS):
            if error == 0.0:
                return at
            following, following_error = self._step(at, -error / slope)
            if following == at:
                return at
            if following_error == error:
                raise UnreachableValue(f"{self.gap.text}: `set` does not change it")
            slope = (following_error - error) / (following - at)
            # If the first step increases the error, the guessed slope has the wrong sign.
            at, error = following, following_error
            if abs(error) < 1e-12 * max(1.0, abs(self.target)):
                return self._last_step(at, error, slope)
        raise UnreachableValue(f"{self.gap.text}: no value was found that makes it {self.target:g} m")

    def _last_step(self, at: float, error: float, slope: float) -> float:
        refined = at - error / slope
        refined_error = self.error(refined)
        return refined if refined_error is not None and abs(refined_error) < abs(error) else at

    def _step(self, at: float, by: float) -> tuple[float, float]:
        """Take a step, shortened if the line would miss the geom."""
        for _ in range(MAX_ITERATIONS):
            error = self.error(at + by)
            if error is not None:
                return at + by, error
            by /= 2
        raise UnreachableValue(f"{self.gap.text}: the line misses the geom before {self.target:g} m is reached")

    def polish(self, value: float) -> float:
        """The adjacent float with the smallest error, to remove rounding errors of the search."""
        best, least = value, math.inf
        for candidate in itertools.chain((value,), _neighbours(value)):
            error = self.error(candidate)
            if error is not None and abs(error) < least:
                best, least = candidate, abs(error)
            if least == 0.0:
                break
        return best


def _neighbours(value: float) -> Iterator[float]:
    below = above = value
    for _ in range(NEIGHBOURS):
        below, above = math.nextafter(below, -math.inf), math.nextafter(above, math.inf)
        yield below
        yield above
