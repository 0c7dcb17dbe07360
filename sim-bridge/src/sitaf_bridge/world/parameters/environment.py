"""Settings of the surroundings and of the machinery: wind, light, actuators, and the devices' own."""

from dataclasses import dataclass
from typing import Any

import mujoco
import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True)
class Wind:
    """A component of the medium's velocity in metres per second; it acts where the MJCF gives density or viscosity."""

    axis: int
    edits_model: bool = True
    lowest: float = -np.inf

    def column(self, batch: Any) -> NDArray[np.float64] | None:
        """Of the options of each."""
        return batch.expand("opt.wind")[:, self.axis]

    def get(self, model: mujoco.MjModel, data: mujoco.MjData) -> float:
        """From the model."""
        return float(model.opt.wind[self.axis])

    def put(self, model: mujoco.MjModel, data: mujoco.MjData, value: float) -> None:
        """Into the model."""
        model.opt.wind[self.axis] = value


@dataclass(frozen=True)
class LightBrightness:
    """How bright a light is: 1 as in the MJCF, 0 dark."""

    light: int
    colour: tuple[float, float, float]
    edits_model: bool = True
    lowest: float = 0.0

    def column(self, batch: Any) -> NDArray[np.float64] | None:
        """Only cameras see it, and those are not read in batches."""
        return None

    def get(self, model: mujoco.MjModel, data: mujoco.MjData) -> float:
        """From the model, by its brightest colour."""
        brightest = int(np.argmax(self.colour))
        return float(model.light_diffuse[self.light, brightest]) / (self.colour[brightest] or 1.0)

    def put(self, model: mujoco.MjModel, data: mujoco.MjData, value: float) -> None:
        """Into the model."""
        model.light_diffuse[self.light] = np.array(self.colour) * value


@dataclass(frozen=True)
class ActuatorGain:
    """The gain of an actuator, and of its feedback along with it: `kp`, `kv`, or the motor's gain."""

    actuator: int
    gain: float
    bias: tuple[float, ...]
    edits_model: bool = True
    lowest: float = 0.0

    def column(self, batch: Any) -> NDArray[np.float64] | None:
        """Several numbers go along."""
        return None

    def get(self, model: mujoco.MjModel, data: mujoco.MjData) -> float:
        """From the model."""
        return float(model.actuator_gainprm[self.actuator, 0])

    def put(self, model: mujoco.MjModel, data: mujoco.MjData, value: float) -> None:
        """Scaled from the compiled values, so that setting back restores every bit."""
        model.actuator_gainprm[self.actuator, 0] = value
        model.actuator_biasprm[self.actuator] = np.array(self.bias) * (value / self.gain)


@dataclass(frozen=True)
class DeviceKnob:
    """The noise, delay or level of a device, which the userdata of the simulation holds."""

    address: int
    edits_model: bool = False
    lowest: float = 0.0

    def column(self, batch: Any) -> NDArray[np.float64] | None:
        """Noise and delay are not made in batches."""
        return None

    def get(self, model: mujoco.MjModel, data: mujoco.MjData) -> float:
        """From the data."""
        return float(data.userdata[self.address])

    def put(self, model: mujoco.MjModel, data: mujoco.MjData, value: float) -> None:
        """Into the data."""
        data.userdata[self.address] = value
