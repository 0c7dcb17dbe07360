"""Name, version and capabilities of this simulator."""

import mujoco

from sitaf_bridge.world.devices import KINDS

ENGINE = "MuJoCo"
ENGINE_VERSION: str = mujoco.mj_versionString()
DEVICE_KINDS = tuple(KINDS)
