"""Shapes as triangles. Geoms of one form share a shape of size 1, which each geom scales."""

from dataclasses import dataclass
from functools import cache

import mujoco
import numpy as np
from numpy.typing import NDArray

SEGMENTS = 24
RINGS = 12


@dataclass(frozen=True, eq=False)
class Shape:
    """Corners (n, 3), their normals or None for flat faces, and triangles (m, 3), counterclockwise from outside."""

    positions: NDArray[np.float32]
    normals: NDArray[np.float32] | None
    triangles: NDArray[np.uint32]


@cache
def plane() -> Shape:
    """The square from -1 to 1 at z = 0, seen from above."""
    corners = np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], np.float32)
    normals = np.tile(np.array([0, 0, 1], np.float32), (4, 1))
    return Shape(corners, normals, np.array([[0, 1, 2], [0, 2, 3]], np.uint32))


@cache
def box() -> Shape:
    """The cube from -1 to 1."""
    positions, normals, triangles = [], [], []
    for axis in range(3):
        for side in (-1.0, 1.0):
            normal = np.eye(3)[axis] * side
            first, second = np.eye(3)[(axis + 1) % 3], np.eye(3)[(axis + 2) % 3] * side
            at = len(positions)
            positions += [
                normal - first - second,
                normal + first - second,
                normal + first + second,
                normal - first + second,
            ]
            normals += [normal] * 4
            triangles += [[at, at + 1, at + 2], [at, at + 2, at + 3]]
    return Shape(np.array(positions, np.float32), np.array(normals, np.float32), np.array(triangles, np.uint32))


@cache
def sphere() -> Shape:
    """The sphere of radius 1."""
    return capsule(1.0, 0.0)


@cache
def cylinder() -> Shape:
    """Radius 1, along z from -1 to 1."""
    angle = np.linspace(0, 2 * np.pi, SEGMENTS + 1)
    ring = np.stack([np.cos(angle), np.sin(angle), np.zeros_like(angle)], axis=1)
    up = np.array([0, 0, 1.0])
    positions, normals, triangles = [*(ring - up), *(ring + up)], [*ring, *ring], _band(0, SEGMENTS)
    for side in (-1.0, 1.0):
        at = len(positions)
        positions += [up * side, *(ring + up * side)]
        normals += [up * side] * (SEGMENTS + 2)
        fan = [[at, at + 1 + i, at + 2 + i] for i in range(SEGMENTS)]
        triangles += fan if side > 0 else [[a, c, b] for a, b, c in fan]
    return Shape(np.array(positions, np.float32), np.array(normals, np.float32), np.array(triangles, np.uint32))


def capsule(radius: float, half: float) -> Shape:
    """A cylinder of the given half length along z, with hemispheres at its ends; metres."""
    turn = np.linspace(0, 2 * np.pi, SEGMENTS + 1)
    # The equator twice, once per hemisphere.
    rise = np.concatenate([np.linspace(-np.pi / 2, 0, RINGS // 2 + 1), np.linspace(0, np.pi / 2, RINGS // 2 + 1)])
    lift = np.repeat([-half, half], RINGS // 2 + 1)
    normals = np.stack(
        [
            np.outer(np.cos(rise), np.cos(turn)),
            np.outer(np.cos(rise), np.sin(turn)),
            np.outer(np.sin(rise), np.ones_like(turn)),
        ],
        axis=-1,
    )
    positions = radius * normals
    positions[..., 2] += lift[:, None]
    triangles = [t for ring in range(len(rise) - 1) for t in _band(ring * (SEGMENTS + 1), SEGMENTS)]
    return Shape(
        positions.reshape(-1, 3).astype(np.float32),
        normals.reshape(-1, 3).astype(np.float32),
        np.array(triangles, np.uint32),
    )


def mesh(model: mujoco.MjModel, index: int) -> Shape:
    """A mesh of the model."""
    first, count = int(model.mesh_vertadr[index]), int(model.mesh_vertnum[index])
    face, faces = int(model.mesh_faceadr[index]), int(model.mesh_facenum[index])
    return Shape(
        model.mesh_vert[first : first + count].astype(np.float32),
        None,
        model.mesh_face[face : face + faces].astype(np.uint32),
    )


def height_field(model: mujoco.MjModel, index: int) -> Shape:
    """The surface of a height field of the model."""
    rows, columns = int(model.hfield_nrow[index]), int(model.hfield_ncol[index])
    first = int(model.hfield_adr[index])
    width, depth, height, _ = model.hfield_size[index]
    x, y = np.meshgrid(np.linspace(-width, width, columns), np.linspace(-depth, depth, rows))
    z = height * model.hfield_data[first : first + rows * columns].reshape(rows, columns)
    corner = (np.arange(rows - 1)[:, None] * columns + np.arange(columns - 1)).ravel()
    triangles = np.concatenate(
        [
            np.stack([corner, corner + 1, corner + columns + 1], axis=1),
            np.stack([corner, corner + columns + 1, corner + columns], axis=1),
        ]
    )
    return Shape(np.stack([x, y, z], axis=-1).reshape(-1, 3).astype(np.float32), None, triangles.astype(np.uint32))


def _band(first: int, segments: int) -> list[list[int]]:
    """Triangles between two rings of corners."""
    below = range(first, first + segments)
    above = segments + 1
    return [t for a in below for t in ([a, a + 1, a + 1 + above], [a, a + 1 + above, a + above])]
