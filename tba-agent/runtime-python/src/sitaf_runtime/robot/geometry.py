"""Vectors and rotations."""

from typing import NamedTuple


class Vector(NamedTuple):
    """A vector; the method that returns it documents the unit."""

    x: float
    y: float
    z: float


class Quaternion(NamedTuple):
    """A rotation as a unit quaternion."""

    x: float
    y: float
    z: float
    w: float
