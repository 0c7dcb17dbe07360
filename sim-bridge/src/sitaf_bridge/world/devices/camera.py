"""Kind `camera`: colour or depth, rendered without a display."""

import os
from collections import OrderedDict
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import Any

import mujoco
import numpy as np

from sitaf_bridge.errors import Unavailable
from sitaf_bridge.world.description.yaml_block import Block, Problems
from sitaf_bridge.world.devices.binding import find, find_all
from sitaf_bridge.world.devices.kind import DeviceDeclaration, DeviceKind, Reading

ENCODINGS = {"rgb": "rgb8", "depth": "32FC1"}
MAX_SIDE = 4096
MAX_RENDERERS = 4


@dataclass(frozen=True)
class CameraDeclaration(DeviceDeclaration):
    """Pixels; `image` is rgb or depth."""

    camera: str
    width: int
    height: int
    image: str


@dataclass(frozen=True)
class Image:
    """Rows from the top; `data` is rgb8, or metres as little endian floats."""

    device: CameraDeclaration
    encoding: str
    data: bytes


class CameraKind(DeviceKind):
    """Kind `camera`."""

    name = "camera"
    image = True

    def declare(self, name: str, block: Block) -> CameraDeclaration | None:
        """Keys `camera`, `width`, `height`, `image`."""
        camera, width, height = block.text("camera"), block.number("width"), block.number("height")
        image = block.optional_text("image", "rgb")
        if camera is None or width is None or height is None or image is None:
            return None
        if image not in ENCODINGS:
            block.problem(f"{block.path}.image: {image!r} is not one of {', '.join(ENCODINGS)}", "image")
        elif not all(1 <= side <= MAX_SIDE and side == int(side) for side in (width, height)):
            block.problem(f"{block.path}: width and height must be whole numbers from 1 to {MAX_SIDE}")
        else:
            return CameraDeclaration(name, self.name, block.line, camera, int(width), int(height), image)
        return None

    def bind(
        self, model: mujoco.MjModel, declarations: Sequence[DeviceDeclaration], problems: Problems
    ) -> "CameraBank":
        """Find the cameras."""

        def camera(declaration: DeviceDeclaration) -> int:
            assert isinstance(declaration, CameraDeclaration)  # noqa: S101
            return find(model, "camera", declaration.camera)

        return CameraBank(find_all(declarations, problems, camera))

    def fields(self, declaration: DeviceDeclaration) -> tuple[str, ...]:
        """An image has no numbers of its own."""
        return ()


class CameraBank:
    """All cameras of a world."""

    def __init__(self, devices: Sequence[tuple[DeviceDeclaration, int]]) -> None:
        self._by_name = {d.name: (d, camera) for d, camera in devices}

    def read(self, model: mujoco.MjModel, data: mujoco.MjData) -> Sequence[Reading]:
        """Images are not read along with numbers."""
        return []

    def look(self, model: mujoco.MjModel, data: mujoco.MjData, device: str) -> Image:
        """The image at the current step. Raises Unavailable where this machine cannot render."""
        declaration, camera = self._by_name[device]
        assert isinstance(declaration, CameraDeclaration)  # noqa: S101
        return _thread.submit(_render, model, data, declaration, camera).result()


# A GL context belongs to one thread; all images of the process are made in this one.
_thread = ThreadPoolExecutor(1, thread_name_prefix="camera")
# Used by that thread only. The model is kept so that its id is not given to another.
_renderers: OrderedDict[tuple[int, int, int], tuple[Any, mujoco.MjModel]] = OrderedDict()


def _render(model: mujoco.MjModel, data: mujoco.MjData, declaration: CameraDeclaration, camera: int) -> Image:
    renderer = _renderer(model, declaration)
    renderer.update_scene(data, camera=camera)
    renderer.scene.flags[mujoco.mjtRndFlag.mjRND_SHADOW] = 0
    renderer.scene.flags[mujoco.mjtRndFlag.mjRND_REFLECTION] = 0
    if declaration.image == "depth":
        renderer.enable_depth_rendering()
    else:
        renderer.disable_depth_rendering()
    pixels = renderer.render()
    kind = np.dtype("<f4") if declaration.image == "depth" else np.dtype(np.uint8)
    return Image(declaration, ENCODINGS[declaration.image], np.ascontiguousarray(pixels, kind).tobytes())


def _renderer(model: mujoco.MjModel, declaration: CameraDeclaration) -> Any:
    key = (id(model), declaration.height, declaration.width)
    if key in _renderers:
        _renderers.move_to_end(key)
        return _renderers[key][0]
    # MuJoCo reads it when its renderer is first loaded, which is here.
    os.environ.setdefault("MUJOCO_GL", "egl")
    try:
        from mujoco.renderer import Renderer  # noqa: PLC0415  # loads GL, which a machine may not have

        renderer = Renderer(model, declaration.height, declaration.width)
    except Exception as error:  # every GL platform raises its own
        raise Unavailable(
            f"the camera {declaration.name} cannot be rendered on this machine: {error}; install EGL "
            "(Debian: libegl1 libgl1-mesa-dri libgles2)"
        ) from error
    _renderers[key] = (renderer, model)
    while len(_renderers) > MAX_RENDERERS:
        _renderers.popitem(last=False)[1][0].close()
    return renderer
