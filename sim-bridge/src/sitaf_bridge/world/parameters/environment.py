"""Settings of the environment, of actuators and of devices."""

from dataclasses import dataclass
from typing import Any

import mujoco
import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True)
class Wind:
    """A component of the wind velocity in metres per second; effective only if the MJCF sets density or viscosity."""

    axis: int
    edits_model: bool = True
    lowest: float = -np.inf

    def column(self, batch: Any) -> NDArray[np.float64] | None:
        """The options of each simulation."""
        return batch.expand("opt.wind")[:, self.axis]

    def get(self, model: mujoco.MjModel, data: mujoco.MjData) -> float:
        """From the model."""
        return float(model.opt.wind[self.axis])

    def put(self, model: mujoco.MjModel, data: mujoco.MjData, value: float) -> None:
        """Into the model."""
        model.opt.wind[self.axis] = value


@dataclass(frozen=True)
class LightBrightness:
    """The brightness of a light: 1 as in the MJCF, 0 dark."""

    light: int
    colour: tuple[float, float, float]
    edits_model: bool = True
    lowest: float = 0.0

    def column(self, batch: Any) -> NDArray[np.float64] | None:
        """Not supported: only cameras see lights, and batches do not read cameras."""
        return None

    def get(self, model: mujoco.MjModel, data: mujoco.MjData) -> float:
        """The brightness relative to the MJCF, by the brightest color component."""
        brightest = int(np.argmax(self.colour))
        return float(model.light_diffuse[self.light, brightest]) / (self.colour[brightest] or 1.0)

    def put(self, model: mujoco.MjModel, data: mujoco.MjData, value: float) -> None:
        """Into the model."""
        model.light_diffuse[self.light] = np.array(self.colour) * value


@dataclass(frozen=True)
class ActuatorGain:
    """The gain of an actuator with its feedback: `kp`, `kv`, or the gain of a motor."""

    actuator: int
    gain: float
    bias: tuple[float, ...]
    edits_model: bool = True
    lowest: float = 0.0

    def column(self, batch: Any) -> NDArray[np.float64] | None:
        """Not supported: the setting writes several numbers."""
        return None

    def get(self, model: mujoco.MjModel, data: mujoco.MjData) -> float:
        """From the model."""
        return float(model.actuator_gainprm[self.actuator, 0])

    def put(self, model: mujoco.MjModel, data: mujoco.MjData, value: float) -> None:
        """Scale the compiled values, so that restoring is exact to the bit."""
        model.actuator_gainprm[self.actuator, 0] = value
        model.actuator_biasprm[self.actuator] = np.array(self.bias) * (value / self.gain)


@dataclass(frozen=True)
class DeviceKnob:
    """The noise, delay or level of a device, stored in the userdata of the simulation."""

    address: int
    edits_model: bool = False
    lowest: float = 0.0

    def column(self, batch: Any) -> NDArray[np.float64] | None:
        """Not supported: batches do not compute noise and delay."""
        return None

    def get(self, model: mujoco.MjModel, data: mujoco.MjData) -> float:
        """From the data."""
        return float(data.userdata[self.address])

    def put(self, model: mujoco.MjModel, data: mujoco.MjData, value: float) -> None:
        """Into the data."""
        data.userdata[self.address] = value
