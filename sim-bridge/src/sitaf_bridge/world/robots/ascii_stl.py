"""Converts text STL, which MuJoCo does not read, to binary STL."""

import re

import numpy as np

VERTEX = re.compile(rb"vertex\s+(\S+)\s+(\S+)\s+(\S+)")
HEADER_BYTES = 80


def as_binary(content: bytes) -> bytes:
    """The binary form of a text STL; anything else unchanged."""
    if not content.lstrip().startswith(b"solid") or b"facet" not in content[:1000]:
        return content
    try:
        corners = np.array(VERTEX.findall(content), dtype=np.float32)
    except ValueError:
        return content
    if len(corners) == 0 or len(corners) % 3:
        return content
    # Of each triangle: a normal, which MuJoCo computes itself, three corners, two bytes of attributes.
    triangles = np.zeros(len(corners) // 3, np.dtype([("numbers", "<f4", 12), ("attributes", "<u2")]))
    triangles["numbers"][:, 3:] = corners.reshape(-1, 9)
    return bytes(HEADER_BYTES) + len(triangles).to_bytes(4, "little") + triangles.tobytes()
