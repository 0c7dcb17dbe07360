"""Vectors and rotations."""

from typing import NamedTuple


class Vector(NamedTuple):
    """Three numbers along x, y and z; the unit stands where it is used."""

    x: float
    y: float
    z: float


class Quaternion(NamedTuple):
    """A rotation, of unit length."""

    x: float
    y: float
    z: float
    w: float
