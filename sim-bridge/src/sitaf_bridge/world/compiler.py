"""Compiles MJCF in a separate process, which cannot open files and may crash without consequences.

MuJoCo reads `include` and asset paths from the host's disk, and some models crash it (a huge texture causes a
segmentation fault). The child process compiles, tries one step, and returns the binary model.
"""

import time
from collections.abc import Mapping
from pathlib import PurePosixPath

import mujoco
import numpy as np

from sitaf_bridge.errors import BadWorld, LimitReached, Problem
from sitaf_bridge.world.additions import Additions, add
from sitaf_bridge.world.description.mjcf_limits import MAX_ITERATIONS
from sitaf_bridge.world.isolation import CPU_SECONDS, MEMORY_BYTES, Crashed, TooSlow, isolated
from sitaf_bridge.world.robots.fitting import fit

MAX_MODEL_BYTES = 256 * 1024**2
MAX_ARENA_BYTES = 1024**3
MAX_STATE_BYTES = 64 * 1024**2
MAX_DEGREES_OF_FREEDOM = 10_000
# Limit for the processor time of the trial step.
MAX_STEP_SECONDS = 2.0
TOO_MUCH_MEMORY = (
    f"the model needs more memory than the limit of {MEMORY_BYTES >> 20} MiB "
    "(for its elements, assets, or the `memory` of <size>); make it smaller"
)
# Fields that must be finite; everything else is computed from them.
FINITE = {
    "body": ("pos", "quat", "ipos", "mass", "inertia"),
    "jnt": ("pos", "axis", "range", "stiffness"),
    "dof": ("damping", "armature", "frictionloss"),
    "geom": ("pos", "quat", "size", "friction"),
    "site": ("pos", "quat", "size"),
    "cam": ("pos", "quat", "fovy"),
    "light": ("pos", "dir"),
    "mesh": ("vert",),
    "hfield": ("data", "size"),
    "actuator": ("gainprm", "biasprm", "ctrlrange", "forcerange"),
    "key": ("qpos", "qvel", "ctrl"),
}
FINITE_OPTIONS = ("timestep", "gravity", "wind", "magnetic", "density", "viscosity", "impratio", "tolerance")


def silence_warnings() -> None:
    """Keep MuJoCo from writing MUJOCO_LOG.TXT and to stdout; divergence is detected in the data instead."""
    mujoco.set_mju_user_warning(lambda _message: None)


def compile_mjcf(
    main: str, files: Mapping[str, bytes], shown: str, additions: Additions | None = None
) -> mujoco.MjModel:
    """Compile the MJCF `main` of `files` with additions; `shown` is its name in messages.

    Raises BadWorld with MuJoCo's message, LimitReached if the model is too big.
    """
    try:
        answer = isolated(_compiled, (main, dict(files), additions or Additions()))
    except TooSlow as error:
        raise LimitReached(f"{shown}: the compilation exceeds {CPU_SECONDS} s; make the model smaller") from error
    except Crashed as error:
        message = f"MuJoCo cannot compile this model: its process ended with {error}"
        raise BadWorld([Problem(shown, None, message)]) from error
    if answer.word == "compiled":
        model = mujoco.MjModel.from_binary_path("model.mjb", {"model.mjb": answer.content})
        silence_warnings()
        return model
    if answer.word == "limit":
        raise LimitReached(f"{shown}: {answer.text}")
    raise BadWorld([Problem(shown, None, answer.text)])


def _compiled(main: str, files: Mapping[str, bytes], additions: Additions) -> tuple[str, bytes]:
    """Run in the separate process."""
    silence_warnings()
    try:
        return _compile(main, files, additions)
    except MemoryError:
        return "limit", TOO_MUCH_MEMORY.encode()
    except (ValueError, RuntimeError, KeyError, mujoco.FatalError) as error:
        message = str(error).strip()
        if "allocate" in message or "out of memory" in message.lower():
            return "limit", TOO_MUCH_MEMORY.encode()
        return "refused", message.encode()


def _compile(main: str, files: Mapping[str, bytes], additions: Additions) -> tuple[str, bytes]:
    folder = str(PurePosixPath(main).parent)
    prefix = "" if folder == "." else folder + "/"
    # MuJoCo resolves paths relative to the folder of the main file.
    assets = {path.removeprefix(prefix): c for path, c in files.items() if path.startswith(prefix)}
    included = {path: content for path, content in assets.items() if path.lower().endswith(".xml")}
    others = {path: content for path, content in assets.items() if path not in included}
    spec = mujoco.MjSpec.from_string(files[main].decode("utf-8"), include=included, assets=others)
    add(spec, additions, others)
    model = spec.compile()
    fit(model, additions.robots)
    for what, size, limit in (
        ("bytes of model", model.nbuffer, MAX_MODEL_BYTES),
        ("bytes of arena (the `memory` of <size>)", model.narena, MAX_ARENA_BYTES),
        ("degrees of freedom", model.nv, MAX_DEGREES_OF_FREEDOM),
        ("iterations of a solver", _iterations(model), MAX_ITERATIONS),
    ):
        if size > limit:
            return "limit", f"the model has {size} {what}; the limit is {limit}".encode()
    endless = _not_finite(model)
    if endless:
        return "refused", f"numbers of the compiled model are not finite: {', '.join(endless)}".encode()
    data = mujoco.MjData(model)
    if data.nbuffer > MAX_STATE_BYTES:
        return "limit", f"the state of the model has {data.nbuffer} bytes; the limit is {MAX_STATE_BYTES}".encode()
    began = time.process_time()
    mujoco.mj_step(model, data)
    took = time.process_time() - began
    if took > MAX_STEP_SECONDS:
        return "limit", f"one step takes {took:.1f} s of processor time; the limit is {MAX_STEP_SECONDS:g} s".encode()
    content = np.empty(mujoco.mj_sizeModel(model), np.uint8)
    mujoco.mj_saveModel(model, None, content)
    return "compiled", content.tobytes()


def _iterations(model: mujoco.MjModel) -> int:
    """The maximum number of solver iterations, including those of attached models."""
    option = model.opt
    return max(getattr(option, f"{solver}iterations") for solver in ("", "ls_", "noslip_", "ccd_", "sdf_"))


def _not_finite(model: mujoco.MjModel) -> list[str]:
    """The fields of the model with NaN or infinity, such as body_pos."""
    fields = [f"{part}_{name}" for part, names in FINITE.items() for name in names]
    found = [field for field in ("qpos0", *fields) if not np.isfinite(getattr(model, field)).all()]
    return found + [f"option {name}" for name in FINITE_OPTIONS if not np.isfinite(getattr(model.opt, name)).all()]
