"""Kind `camera`: color or depth images, rendered without a display."""

from collections.abc import Sequence
from dataclasses import dataclass

import mujoco
import numpy as np

from sitaf_bridge.errors import Unavailable
from sitaf_bridge.world.description.yaml_block import Block, Problems
from sitaf_bridge.world.devices.binding import find, find_all
from sitaf_bridge.world.devices.kind import DeviceDeclaration, DeviceKind, Reading
from sitaf_bridge.world.rendering import CannotRender, picture

ENCODINGS = {"rgb": "rgb8", "depth": "32FC1"}
MAX_SIDE = 4096


@dataclass(frozen=True)
class CameraDeclaration(DeviceDeclaration):
    """Size in pixels; `image` is rgb or depth."""

    camera: str
    width: int
    height: int
    image: str


@dataclass(frozen=True)
class Image:
    """Rows from the top; `data` is rgb8, or metres as little-endian floats."""

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
        """An image has no numeric fields."""
        return ()


class CameraBank:
    """All cameras of a world."""

    def __init__(self, devices: Sequence[tuple[DeviceDeclaration, int]]) -> None:
        self._by_name = {d.name: (d, camera) for d, camera in devices}

    def read(self, model: mujoco.MjModel, data: mujoco.MjData) -> Sequence[Reading]:
        """Images are not part of the numeric readings."""
        return []

    def look(self, model: mujoco.MjModel, data: mujoco.MjData, device: str) -> Image:
        """Render the image at the current step. Raises Unavailable if this machine cannot render."""
        declaration, camera = self._by_name[device]
        assert isinstance(declaration, CameraDeclaration)  # noqa: S101
        size, depth = (declaration.width, declaration.height), declaration.image == "depth"
        try:
            pixels = picture(model, data, camera, size, depth=depth)
        except CannotRender as error:
            raise Unavailable(f"the camera {device} cannot be rendered on this machine: {error}") from error
        kind = np.dtype("<f4") if depth else np.dtype(np.uint8)
        data_bytes = np.ascontiguousarray(pixels, kind).tobytes()
        return Image(declaration, ENCODINGS[declaration.image], data_bytes)
