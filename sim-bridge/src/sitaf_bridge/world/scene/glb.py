"""Writes binary glTF 2.0 (GLB), the Khronos Group's file format for 3D scenes."""

import json
import struct
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sitaf_bridge.errors import LimitReached

MAX_BYTES = 48 * 1024 * 1024
MAGIC, VERSION = 0x46546C67, 2
JSON_CHUNK, BINARY_CHUNK = 0x4E4F534A, 0x004E4942
# componentType by data type, and type by the number of components.
COMPONENTS = {"float32": 5126, "uint32": 5125}
TYPES = {1: "SCALAR", 3: "VEC3", 4: "VEC4"}

Array = NDArray[np.float32] | NDArray[np.uint32]


class Glb:
    """A file under construction. Indices refer to glTF's own lists."""

    def __init__(self) -> None:
        self.extras: dict[str, Any] = {}
        self._lists: dict[str, list[dict[str, Any]]] = {}
        self._roots: list[int] = []
        self._binary: list[bytes] = []
        self._size = 0

    def copy(self) -> "Glb":
        """A copy; changes of its entries do not affect this one."""
        copied = Glb()
        copied.extras = dict(self.extras)
        copied._lists = {kind: [dict(entry) for entry in entries] for kind, entries in self._lists.items()}
        copied._roots, copied._binary, copied._size = [*self._roots], [*self._binary], self._size
        return copied

    def add(self, kind: str, **entry: Any) -> int:
        """Add an entry to one of glTF's lists, such as `nodes`; returns its index."""
        entries = self._lists.setdefault(kind, [])
        entries.append(entry)
        return len(entries) - 1

    def entry(self, kind: str, index: int) -> dict[str, Any]:
        """An entry that can still be modified."""
        return self._lists[kind][index]

    def add_root(self, node: int) -> None:
        """Add a node to the scene."""
        self._roots.append(node)

    def view(self, array: Array) -> int:
        """Add numbers to the binary part; returns the index of their buffer view. Raises LimitReached."""
        content = array.astype(array.dtype.newbyteorder("<"), copy=False).tobytes()
        if self._size + len(content) > MAX_BYTES:
            raise LimitReached(f"the scene exceeds {MAX_BYTES} bytes; simplify the world's meshes")
        index = self.add("bufferViews", buffer=0, byteOffset=self._size, byteLength=len(content))
        self._binary.append(content + bytes(-len(content) % 4))
        self._size += len(self._binary[-1])
        return index

    def accessor(self, array: Array) -> int:
        """Add the rows of an array (n,), (n, 3) or (n, 4) to the binary part; returns the index of their accessor."""
        rows = array.reshape(len(array), -1)
        return self.add(
            "accessors",
            bufferView=self.view(array),
            componentType=COMPONENTS[array.dtype.name],
            count=len(rows),
            type=TYPES[rows.shape[1]],
            min=rows.min(axis=0).tolist(),
            max=rows.max(axis=0).tolist(),
        )

    def content(self) -> bytes:
        """The complete file."""
        scene: dict[str, Any] = {"nodes": self._roots}
        if self.extras:
            scene["extras"] = self.extras
        document: dict[str, Any] = {
            "asset": {"version": "2.0", "generator": "SITAF"},
            "scene": 0,
            "scenes": [scene],
            **self._lists,
        }
        if self._size:
            document["buffers"] = [{"byteLength": self._size}]
        text = json.dumps(document, separators=(",", ":"), allow_nan=False).encode()
        text += b" " * (-len(text) % 4)
        chunks = [struct.pack("<II", len(text), JSON_CHUNK), text]
        if self._size:
            chunks += [struct.pack("<II", self._size, BINARY_CHUNK), *self._binary]
        length = 12 + sum(map(len, chunks))
        return b"".join([struct.pack("<III", MAGIC, VERSION, length), *chunks])
