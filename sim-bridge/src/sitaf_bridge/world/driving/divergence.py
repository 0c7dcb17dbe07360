"""Whether MuJoCo met numbers that are none: it would put the simulation back silently."""

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
    """Of one simulation's data."""

    def __init__(self, data: mujoco.MjData) -> None:
        # A view: looking it up costs more than looking at it.
        self._warnings = data.warning.number

    def seen(self) -> bool:
        """Whether it happened since the data were reset."""
        return any(self._warnings.take(FATAL).tolist())

    def told(self, step: int) -> str:
        """What a client is told that meets it at a step."""
        return (
            f"the simulation diverged at or before step {step} (NaN, infinity or a huge value); "
            "reset it with RESET_SCOPE_ALL or delete the session; a smaller timestep or softer contacts may help"
        )
