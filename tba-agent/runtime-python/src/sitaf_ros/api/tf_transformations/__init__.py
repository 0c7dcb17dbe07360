"""Rotations as quaternions x, y, z, w, Euler angles in rad and 4 x 4 matrices.

The axes string has `s` for fixed and `r` for rotating axes, then the order: the default `sxyz` is roll, pitch, yaw.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

_AXES = {"x": 0, "y": 1, "z": 2}


def _axis_rotation(axis: str, angle: float) -> Any:
    c, s = math.cos(angle), math.sin(angle)
    i = _AXES[axis]
    j, k = (i + 1) % 3, (i + 2) % 3
    made = np.identity(4)
    made[j, j] = made[k, k] = c
    made[j, k], made[k, j] = -s, s
    return made


def euler_matrix(ai: float, aj: float, ak: float, axes: str = "sxyz") -> Any:
    first, second, third = (_axis_rotation(a, angle) for a, angle in zip(axes[1:], (ai, aj, ak), strict=True))
    return third @ second @ first if axes[0] == "s" else first @ second @ third


def euler_from_matrix(matrix: Any, axes: str = "sxyz") -> tuple[float, float, float]:
    m = np.asarray(matrix, dtype=float)[:3, :3]
    order = axes[1:] if axes[0] == "s" else axes[:0:-1]
    i, j = _AXES[order[0]], _AXES[order[1]]
    repeats = order[0] == order[2]
    k = 3 - i - j
    odd = (j - i) % 3 == 2
    if repeats:
        size = math.hypot(m[i, j], m[i, k])
        if size > 1e-12:
            found = (math.atan2(m[i, j], m[i, k]), math.atan2(size, m[i, i]), math.atan2(m[j, i], -m[k, i]))
        else:
            found = (math.atan2(-m[j, k], m[j, j]), math.atan2(size, m[i, i]), 0.0)
    else:
        size = math.hypot(m[i, i], m[j, i])
        if size > 1e-12:
            found = (math.atan2(m[k, j], m[k, k]), math.atan2(-m[k, i], size), math.atan2(m[j, i], m[i, i]))
        else:
            found = (math.atan2(-m[j, k], m[j, j]), math.atan2(-m[k, i], size), 0.0)
    a, b, c = (-angle for angle in found) if odd else found
    return (a, b, c) if axes[0] == "s" else (c, b, a)


def quaternion_from_matrix(matrix: Any, isprecise: bool = False) -> Any:
    m = np.asarray(matrix, dtype=float)
    trace = m[0, 0] + m[1, 1] + m[2, 2]
    if trace > 0:
        s = 2 * math.sqrt(trace + 1)
        q = [(m[2, 1] - m[1, 2]) / s, (m[0, 2] - m[2, 0]) / s, (m[1, 0] - m[0, 1]) / s, s / 4]
    else:
        i = int(np.argmax(np.diag(m)[:3]))
        j, k = (i + 1) % 3, (i + 2) % 3
        s = 2 * math.sqrt(max(0.0, 1 + m[i, i] - m[j, j] - m[k, k]))
        q = [0.0, 0.0, 0.0, (m[k, j] - m[j, k]) / s]
        q[i], q[j], q[k] = s / 4, (m[j, i] + m[i, j]) / s, (m[k, i] + m[i, k]) / s
    return np.array(q)


def quaternion_matrix(quaternion: Any) -> Any:
    x, y, z, w = np.asarray(quaternion, dtype=float)
    n = x * x + y * y + z * z + w * w
    made = np.identity(4)
    if n < 1e-20:
        return made
    s = 2 / n
    made[:3, :3] = [
        [1 - s * (y * y + z * z), s * (x * y - z * w), s * (x * z + y * w)],
        [s * (x * y + z * w), 1 - s * (x * x + z * z), s * (y * z - x * w)],
        [s * (x * z - y * w), s * (y * z + x * w), 1 - s * (x * x + y * y)],
    ]
    return made


def quaternion_from_euler(ai: float, aj: float, ak: float, axes: str = "sxyz") -> Any:
    halves = [_about(a, angle) for a, angle in zip(axes[1:], (ai, aj, ak), strict=True)]
    first, second, third = halves if axes[0] == "r" else halves[::-1]
    return quaternion_multiply(quaternion_multiply(first, second), third)


def _about(axis: str, angle: float) -> Any:
    made = np.array([0.0, 0.0, 0.0, math.cos(angle / 2)])
    made[_AXES[axis]] = math.sin(angle / 2)
    return made


def euler_from_quaternion(quaternion: Any, axes: str = "sxyz") -> tuple[float, float, float]:
    return euler_from_matrix(quaternion_matrix(quaternion), axes)


def quaternion_about_axis(angle: float, axis: Any) -> Any:
    unit = np.asarray(axis, dtype=float)
    unit = unit / np.linalg.norm(unit)
    return np.array([*(unit * math.sin(angle / 2)), math.cos(angle / 2)])


def quaternion_multiply(quaternion1: Any, quaternion0: Any) -> Any:
    from sitaf_ros.transform_tree import multiplied

    return np.array(multiplied(tuple(quaternion1), tuple(quaternion0)))  # type: ignore[arg-type]


def quaternion_conjugate(quaternion: Any) -> Any:
    x, y, z, w = quaternion
    return np.array([-x, -y, -z, w])


def quaternion_inverse(quaternion: Any) -> Any:
    return quaternion_conjugate(quaternion) / np.dot(quaternion, quaternion)


def quaternion_slerp(quat0: Any, quat1: Any, fraction: float, spin: int = 0, shortestpath: bool = True) -> Any:
    from sitaf_ros.transform_tree import slerp

    return np.array(slerp(tuple(unit_vector(quat0)), tuple(unit_vector(quat1)), fraction))  # type: ignore[arg-type]


def identity_matrix() -> Any:
    return np.identity(4)


def translation_matrix(direction: Any) -> Any:
    made = np.identity(4)
    made[:3, 3] = np.asarray(direction)[:3]
    return made


def translation_from_matrix(matrix: Any) -> Any:
    return np.array(matrix)[:3, 3].copy()


def rotation_matrix(angle: float, direction: Any, point: Any = None) -> Any:
    made = quaternion_matrix(quaternion_about_axis(angle, np.asarray(direction)[:3]))
    if point is not None:
        at = np.asarray(point, dtype=float)[:3]
        made[:3, 3] = at - made[:3, :3] @ at
    return made


def inverse_matrix(matrix: Any) -> Any:
    return np.linalg.inv(matrix)


def concatenate_matrices(*matrices: Any) -> Any:
    made = np.identity(4)
    for matrix in matrices:
        made = made @ matrix
    return made


def vector_norm(data: Any, axis: Any = None) -> Any:
    return np.linalg.norm(data, axis=axis)


def unit_vector(data: Any, axis: Any = None) -> Any:
    values = np.asarray(data, dtype=float)
    return values / np.linalg.norm(values, axis=axis, keepdims=axis is not None)
