"""Renders images without a display, using EGL in software or hardware.

MuJoCo's own Renderer selects its GL platform by an environment variable when MuJoCo is imported, which fails on a
machine without that platform. Here it is loaded for the first image.
"""

from collections import OrderedDict
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import mujoco
import numpy as np
from numpy.typing import NDArray

MAX_PAINTERS = 4
MAX_GEOMS = 10_000


class CannotRender(Exception):
    """This machine has no working GL; the message says what is missing."""


def picture(
    model: mujoco.MjModel, data: mujoco.MjData, camera: int, size: tuple[int, int], *, depth: bool
) -> NDArray[np.float32] | NDArray[np.uint8]:
    """The image of a camera: (height, width, 3) colors, or (height, width) depths in metres along its axis.

    `size` is width and height. Raises CannotRender.
    """
    return _thread.submit(_paint, model, data, camera, size, depth).result()


# A GL context belongs to one thread, so this thread renders all images of the process.
_thread = ThreadPoolExecutor(1, thread_name_prefix="camera")
# Used by that thread only. The model is kept so that its id is not reused.
_painters: OrderedDict[int, tuple[mujoco.MjModel, Any, Any]] = OrderedDict()
_context: Any = None


def _paint(
    model: mujoco.MjModel, data: mujoco.MjData, camera: int, size: tuple[int, int], depth: bool
) -> NDArray[np.float32] | NDArray[np.uint8]:
    scene, context = _painter(model)
    view = mujoco.MjvCamera()
    view.type = mujoco.mjtCamera.mjCAMERA_FIXED
    view.fixedcamid = camera
    everything = int(mujoco.mjtCatBit.mjCAT_ALL)
    mujoco.mjv_updateScene(model, data, mujoco.MjvOption(), None, view, everything, scene)
    scene.flags[mujoco.mjtRndFlag.mjRND_SHADOW] = 0
    scene.flags[mujoco.mjtRndFlag.mjRND_REFLECTION] = 0
    width, height = size
    area = mujoco.MjrRect(0, 0, width, height)
    mujoco.mjr_render(area, scene, context)
    if not depth:
        colours = np.empty((height, width, 3), np.uint8)
        mujoco.mjr_readPixels(colours, None, area, context)
        return colours[::-1]
    nearness = np.empty((height, width), np.float32)
    mujoco.mjr_readPixels(None, nearness, area, context)
    # The buffer holds near / distance, scaled such that the far plane is 0 and the near plane 1.
    near, far = (float(edge) * float(model.stat.extent) for edge in (model.vis.map.znear, model.vis.map.zfar))
    return (near * far / (near + nearness[::-1].astype(np.float64) * (far - near))).astype(np.float32)


def _painter(model: mujoco.MjModel) -> tuple[Any, Any]:
    key = id(model)
    if key not in _painters:
        _start()
        scene = mujoco.MjvScene(model, MAX_GEOMS)
        context = mujoco.MjrContext(model, int(mujoco.mjtFontScale.mjFONTSCALE_100))
        mujoco.mjr_setBuffer(int(mujoco.mjtFramebuffer.mjFB_OFFSCREEN), context)
        context.readDepthMap = mujoco.mjtDepthMap.mjDEPTH_ZEROFAR
        _painters[key] = (model, scene, context)
        while len(_painters) > MAX_PAINTERS:
            _painters.popitem(last=False)[1][2].free()
    _painters.move_to_end(key)
    _, scene, context = _painters[key]
    return scene, context


def _start() -> None:
    global _context  # noqa: PLW0603  # of the one thread that uses it
    if _context is not None:
        return
    try:
        from mujoco.egl import GLContext  # noqa: PLC0415  # loads libraries that a machine may not have

        context = GLContext(1, 1)
        context.make_current()
    except Exception as error:  # the loaders of GL raise whatever they please
        raise CannotRender(
            f"{type(error).__name__}: {error}; install EGL (Debian: libegl1 libgl1-mesa-dri libgles2)"
        ) from error
    _context = context
