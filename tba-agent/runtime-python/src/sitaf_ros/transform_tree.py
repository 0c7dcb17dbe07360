"""A tree of frames with transforms over time, as tf2's buffer core defines it.

Rotations are quaternions x, y, z, w; positions are in m, times in ns. See REP-105 and
https://docs.ros.org/en/jazzy/Concepts/Intermediate/About-Tf2.html.
"""

from __future__ import annotations

import bisect
import math
from dataclasses import dataclass, field

Vector = tuple[float, float, float]
Quaternion = tuple[float, float, float, float]
CACHE_NS = 10 * 10**9
NORM_TOLERANCE = 1e-2
MAX_DEPTH = 1000


class TransformError(Exception):
    """Base of the errors of lookups."""


class UnknownFrameError(TransformError):
    """A frame was never seen."""


class UnconnectedError(TransformError):
    """Two frames are in different trees."""


class ExtrapolationError(TransformError):
    """There is no data at the time asked for."""


class ArgumentError(TransformError):
    """A frame's name is not valid."""


@dataclass(frozen=True)
class Rigid:
    """A rotation, then a translation."""

    translation: Vector = (0.0, 0.0, 0.0)
    rotation: Quaternion = (0.0, 0.0, 0.0, 1.0)

    def then(self, outer: Rigid) -> Rigid:
        """Apply this transform first, then `outer`."""
        moved = rotated(outer.rotation, self.translation)
        return Rigid(_plus(moved, outer.translation), multiplied(outer.rotation, self.rotation))

    def inverse(self) -> Rigid:
        """Return the inverse."""
        x, y, z, w = self.rotation
        back = (-x, -y, -z, w)
        a, b, c = rotated(back, self.translation)
        return Rigid((-a, -b, -c), back)

    def applied(self, point: Vector) -> Vector:
        """Return the point in the target frame."""
        return _plus(rotated(self.rotation, point), self.translation)


def _plus(a: Vector, b: Vector) -> Vector:
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def multiplied(a: Quaternion, b: Quaternion) -> Quaternion:
    """Return the rotation `b`, then `a`."""
    ax, ay, az, aw = a
    bx, by, bz, bw = b
    return (
        aw * bx + ax * bw + ay * bz - az * by,
        aw * by - ax * bz + ay * bw + az * bx,
        aw * bz + ax * by - ay * bx + az * bw,
        aw * bw - ax * bx - ay * by - az * bz,
    )


def rotated(q: Quaternion, v: Vector) -> Vector:
    """Return the vector after a rotation."""
    x, y, z, w = q
    # v + 2 w (u x v) + 2 u x (u x v), u being the vector part
    cx, cy, cz = y * v[2] - z * v[1], z * v[0] - x * v[2], x * v[1] - y * v[0]
    dx, dy, dz = y * cz - z * cy, z * cx - x * cz, x * cy - y * cx
    return (v[0] + 2 * (w * cx + dx), v[1] + 2 * (w * cy + dy), v[2] + 2 * (w * cz + dz))


def slerp(a: Quaternion, b: Quaternion, share: float) -> Quaternion:
    """Interpolate on the shorter arc (Shoemake, 1985)."""
    dot = sum(p * q for p, q in zip(a, b, strict=True))
    if dot < 0:
        b, dot = (-b[0], -b[1], -b[2], -b[3]), -dot
    if dot > 1 - 1e-12:
        return a
    angle = math.acos(min(1.0, dot))
    p, q = math.sin((1 - share) * angle) / math.sin(angle), math.sin(share * angle) / math.sin(angle)
    return (p * a[0] + q * b[0], p * a[1] + q * b[1], p * a[2] + q * b[2], p * a[3] + q * b[3])


@dataclass
class _Frame:
    static: tuple[str, Rigid] | None = None
    times: list[int] = field(default_factory=list)
    data: list[tuple[str, Rigid]] = field(default_factory=list)

    def parent(self) -> str | None:
        if self.static is not None:
            return self.static[0]
        return self.data[-1][0] if self.data else None


class TransformTree:
    """All frames that were seen."""

    def __init__(self, cache_ns: int = CACHE_NS) -> None:
        self._cache_ns = cache_ns
        self._frames: dict[str, _Frame] = {}
        self.known: dict[str, None] = {}

    def clear(self) -> None:
        """Forget everything but static transforms."""
        for frame in self._frames.values():
            frame.times.clear()
            frame.data.clear()

    def set(self, parent: str, child: str, transform: Rigid, time_ns: int, static: bool) -> str | None:
        """Add a transform of the child in the parent; return why it is refused, or None."""
        parent, child = parent.lstrip("/"), child.lstrip("/")
        if child == parent:
            return f'frame_id and child_frame_id "{child}" are the same'
        if not child or not parent:
            return "child_frame_id or frame_id not set"
        values = (*transform.translation, *transform.rotation)
        if not all(math.isfinite(value) for value in values):
            return f'a nan value in the transform of child_frame_id "{child}"'
        if abs(math.hypot(*transform.rotation) - 1) > NORM_TOLERANCE:
            return f'an invalid quaternion in the transform of child_frame_id "{child}"'
        self.known[parent] = self.known[child] = None
        frame = self._frames.setdefault(child, _Frame())
        if static:
            frame.static = (parent, transform)
            return None
        frame.static = None
        if frame.times and time_ns < frame.times[-1] - self._cache_ns:
            return f"old data for frame {child}"
        at = bisect.bisect_left(frame.times, time_ns)
        if at < len(frame.times) and frame.times[at] == time_ns:
            return f"redundant timestamp for frame {child}"
        frame.times.insert(at, time_ns)
        frame.data.insert(at, (parent, transform))
        while frame.times[0] < frame.times[-1] - self._cache_ns:
            del frame.times[0], frame.data[0]
        return None

    def lookup(self, target: str, source: str, time_ns: int) -> tuple[Rigid, int]:
        """Return what takes points from the source frame to the target frame; time 0 is the latest common time."""
        for name, role in ((target, "target_frame"), (source, "source_frame")):
            self._check(name, role)
        up, down = self._paths(target, source)
        if time_ns == 0:
            time_ns = self._latest_common(up + down, source)
        total = Rigid()
        for frame in up:
            total = total.then(self._at(frame, time_ns, target, source))
        back = Rigid()
        for frame in down:
            back = back.then(self._at(frame, time_ns, target, source))
        return total.then(back.inverse()), time_ns

    def _check(self, name: str, role: str) -> None:
        if not name:
            raise ArgumentError(
                f"Invalid argument passed to lookupTransform argument {role} in tf2 frame_ids cannot be empty"
            )
        if name.startswith("/"):
            raise ArgumentError(
                f'Invalid argument "{name}" passed to lookupTransform argument {role} in tf2 frame_ids cannot start '
                f"with a '/' like: "
            )
        if name not in self.known:
            raise UnknownFrameError(f'"{name}" passed to lookupTransform argument {role} does not exist. ')

    def ancestors(self, name: str) -> list[str]:
        """Return a frame and all above it."""
        found = [name]
        while (frame := self._frames.get(found[-1])) is not None and (parent := frame.parent()) is not None:
            if len(found) > MAX_DEPTH or parent in found:
                raise UnconnectedError(f"The tf tree is invalid because it contains a loop at {parent}")
            found.append(parent)
        return found

    def _paths(self, target: str, source: str) -> tuple[list[str], list[str]]:
        """Return the frames to climb from the source, and those from the target, up to the common ancestor."""
        above_source, above_target = self.ancestors(source), self.ancestors(target)
        common = next((name for name in above_source if name in above_target), None)
        if common is None:
            raise UnconnectedError(
                f"Could not find a connection between '{target}' and '{source}' because they are not part of the "
                f"same tree.Tf has two or more unconnected trees."
            )
        return above_source[: above_source.index(common)], above_target[: above_target.index(common)]

    def _latest_common(self, frames: list[str], source: str) -> int:
        times = [self._frames[name].times[-1] for name in frames if self._frames[name].static is None]
        if not frames and source in self._frames and self._frames[source].times:
            return self._frames[source].times[-1]
        return min(times, default=0)

    def _at(self, name: str, time_ns: int, target: str, source: str) -> Rigid:
        frame = self._frames[name]
        if frame.static is not None:
            return frame.static[1]
        times = frame.times
        at = bisect.bisect_left(times, time_ns)
        if at < len(times) and times[at] == time_ns:
            return frame.data[at][1]
        where = f", when looking up transform from frame [{source}] to frame [{target}]"
        if len(times) == 1:
            raise ExtrapolationError(
                f"Lookup would require extrapolation at time {time_ns / 1e9:f}, but only time {times[0] / 1e9:f} is in "
                f"the buffer{where}"
            )
        if at == len(times):
            raise ExtrapolationError(
                f"Lookup would require extrapolation into the future.  Requested time {time_ns / 1e9:f} but the latest "
                f"data is at time {times[-1] / 1e9:f}{where}"
            )
        if at == 0:
            raise ExtrapolationError(
                f"Lookup would require extrapolation into the past.  Requested time {time_ns / 1e9:f} but the earliest "
                f"data is at time {times[0] / 1e9:f}{where}"
            )
        (parent, low), (_, high) = frame.data[at - 1], frame.data[at]
        if parent != frame.data[at][0]:
            return low
        share = (time_ns - times[at - 1]) / (times[at] - times[at - 1])
        a, b = low.translation, high.translation
        moved = (a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1]), a[2] + share * (b[2] - a[2]))
        return Rigid(moved, slerp(low.rotation, high.rotation, share))

    def parents(self) -> dict[str, str]:
        """Return the parent of each frame that has one."""
        return {name: parent for name, frame in self._frames.items() if (parent := frame.parent()) is not None}
