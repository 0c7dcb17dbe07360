"""Compiles MJCF in a separate process, which cannot open files and may crash without consequences.

MuJoCo reads `include` and asset paths from the host's disk, and some models crash it (a huge texture causes a
segmentation fault). The child process is forked with MuJoCo loaded, gives up all rights to open files, limits its
memory and processor time, compiles, tries one step, and returns the binary model.
"""

import multiprocessing
import os
import resource
import signal
import tempfile
import threading
import time
from collections.abc import Mapping
from multiprocessing.connection import Connection
from pathlib import PurePosixPath

import mujoco
import numpy as np

from sitaf_bridge.errors import BadWorld, LimitReached, Problem
from sitaf_bridge.world.additions import Additions, add
from sitaf_bridge.world.description.mjcf_limits import MAX_ITERATIONS

CPU_SECONDS = 30
WALL_SECONDS = 60.0
# Lower than the memory limit of a build's bridge, so that the error names the world as the cause.
MEMORY_BYTES = 1536 * 1024**2
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
# Limits the number of concurrent compilations.
COMPILING = threading.BoundedSemaphore(2)

# The fork server imports this module, and with it MuJoCo, once; each child is a cheap fork of it.
_processes = multiprocessing.get_context("forkserver")
_processes.set_forkserver_preload([__name__])


def silence_warnings() -> None:
    """Keep MuJoCo from writing MUJOCO_LOG.TXT and to stdout; divergence is detected in the data instead."""
    mujoco.set_mju_user_warning(lambda _message: None)


def compile_mjcf(
    main: str, files: Mapping[str, bytes], shown: str, additions: Additions | None = None
) -> mujoco.MjModel:
    """Compile the MJCF `main` of `files` with additions; `shown` is its name in messages.

    Raises BadWorld with MuJoCo's message, LimitReached if the model is too big.
    """
    with COMPILING:
        receiver, sender = _processes.Pipe(duplex=False)
        process = _processes.Process(
            target=_child, args=(sender, main, dict(files), additions or Additions()), daemon=True
        )
        process.start()
        sender.close()
        try:
            answer = receiver.recv() if receiver.poll(WALL_SECONDS) else ("slow", b"")
        except EOFError:
            answer = ("crashed", b"")
        finally:
            receiver.close()
            process.join(0.5)
            if process.is_alive():
                process.kill()
                process.join()
    verdict, content = answer
    if verdict == "compiled":
        model = mujoco.MjModel.from_binary_path("model.mjb", {"model.mjb": content})
        silence_warnings()
        return model
    message = content.decode("utf-8", "replace")
    if verdict == "limit":
        raise LimitReached(f"{shown}: {message}")
    if verdict == "crashed":
        message = f"MuJoCo cannot compile this model: its process ended with {_ending(process.exitcode)}"
    if verdict == "slow" or process.exitcode == -signal.SIGXCPU:
        raise LimitReached(f"{shown}: the compilation exceeds {CPU_SECONDS} s; make the model smaller")
    raise BadWorld([Problem(shown, None, message)])


def _ending(code: int | None) -> str:
    if code is not None and code < 0:
        return f"{signal.Signals(-code).name} (too large, or a defect of MuJoCo)"
    return f"exit code {code}"


def _child(answer: Connection, main: str, files: Mapping[str, bytes], additions: Additions) -> None:
    """Run in the forked process."""
    silence_warnings()
    with tempfile.TemporaryDirectory() as empty:
        os.chdir(empty)
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    resource.setrlimit(resource.RLIMIT_CPU, (CPU_SECONDS, CPU_SECONDS + 1))
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY_BYTES, MEMORY_BYTES))
    # From here on the process cannot open any file, socket or device.
    resource.setrlimit(resource.RLIMIT_NOFILE, (0, 0))
    try:
        answer.send(_compile(main, files, additions))
    except MemoryError:
        answer.send(("limit", TOO_MUCH_MEMORY.encode()))
    except (ValueError, RuntimeError, KeyError, mujoco.FatalError) as error:
        message = str(error).strip()
        if "allocate" in message or "out of memory" in message.lower():
            answer.send(("limit", TOO_MUCH_MEMORY.encode()))
        else:
            answer.send(("refused", message.encode()))


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
