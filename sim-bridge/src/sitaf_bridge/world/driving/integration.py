"""The second half of a time step: MuJoCo's `mj_step` is `mj_forward` followed by an integration."""

from collections.abc import Callable

import mujoco

INTEGRATIONS: dict[int, Callable[[mujoco.MjModel, mujoco.MjData], None]] = {
    int(mujoco.mjtIntegrator.mjINT_EULER): mujoco.mj_Euler,
    int(mujoco.mjtIntegrator.mjINT_RK4): lambda model, data: mujoco.mj_RungeKutta(model, data, 4),
    int(mujoco.mjtIntegrator.mjINT_IMPLICIT): mujoco.mj_implicit,
    int(mujoco.mjtIntegrator.mjINT_IMPLICITFAST): mujoco.mj_implicit,
}


def integration_of(model: mujoco.MjModel) -> Callable[[mujoco.MjModel, mujoco.MjData], None]:
    """The function that advances data by one step after `mj_forward`.

    The state is the same as after `mj_step`, bit by bit. For other integrators it is `mj_step`, which repeats the
    first half.
    """
    integrate = INTEGRATIONS.get(int(model.opt.integrator))
    if integrate is None:
        return mujoco.mj_step

    def advance(model: mujoco.MjModel, data: mujoco.MjData) -> None:
        mujoco.mj_checkAcc(model, data)
        integrate(model, data)

    return advance
