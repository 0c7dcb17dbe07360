"""Detects NaN, infinity and huge values, after which MuJoCo silently resets the simulation."""

import mujoco
import numpy as np

FATAL = np.array(
    [
        int(warning)
        for warning in (
            mujoco.mjtWarning.mjWARN_BADQPOS,
            mujoco.mjtWarning.mjWARN_BADQVEL,
            mujoco.mjtWarning.mjWARN_BADQACC,
            mujoco.mjtWarning.mjWARN_BADCTRL,
        )
    ]
)


class Divergence:
    """Checks the data of one simulation."""

    def __init__(self, data: mujoco.MjData) -> None:
        # A view, because looking up the attribute takes longer than reading it.
        self._warnings = data.warning.number

    def seen(self) -> bool:
        """Whether the simulation diverged since the last reset."""
        return any(self._warnings.take(FATAL).tolist())

    def message(self, step: int) -> str:
        """The message for a client."""
        return (
            f"the simulation diverged at or before step {step} (NaN, infinity or a huge value); "
            "reset it with RESET_SCOPE_ALL or delete the session; a smaller timestep or softer contacts may help"
        )
