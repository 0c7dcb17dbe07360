"""Observations: coordinates of bodies that no device of the robot measures."""

import math
from dataclasses import dataclass

import mujoco

from sitaf_bridge.world.description.declaration import AXES, Observation
from sitaf_bridge.world.parameters.settings import name_to_id


@dataclass(frozen=True)
class BoundObservation:
    """A coordinate of one body in the world's frame."""

    body: int
    axis: int

    def measure(self, data: mujoco.MjData) -> float:
        """Metres for x, y, z; radians for roll, pitch, yaw (REP-103: fixed axes x, y, z)."""
        if self.axis < 3:
            return float(data.xpos[self.body, self.axis])
        m = data.xmat[self.body]
        if self.axis == 3:
            return math.atan2(m[7], m[8])
        if self.axis == 4:
            return math.asin(max(-1.0, min(1.0, -m[6])))
        return math.atan2(m[3], m[0])


def find_observation(model: mujoco.MjModel, observation: Observation) -> BoundObservation:
    """Bind a declared observation to a model. Raises NoSuchSetting."""
    body = name_to_id(model, mujoco.mjtObj.mjOBJ_BODY, "body", observation.entity)
    return BoundObservation(body, AXES.index(observation.axis))
