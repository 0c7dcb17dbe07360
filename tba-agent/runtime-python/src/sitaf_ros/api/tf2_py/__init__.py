"""Exceptions and the core of tf2."""

from __future__ import annotations

from typing import Any

from sitaf_ros.transform_tree import (
    ArgumentError,
    ExtrapolationError,
    Rigid,
    TransformError,
    TransformTree,
    UnconnectedError,
    UnknownFrameError,
)

__all__ = [
    "BufferCore",
    "ConnectivityException",
    "ExtrapolationException",
    "InvalidArgumentException",
    "LookupException",
    "TimeoutException",
    "TransformException",
]


class TransformException(Exception):
    pass


class ConnectivityException(TransformException):
    pass


class LookupException(TransformException):
    pass


class ExtrapolationException(TransformException):
    pass


class InvalidArgumentException(TransformException):
    pass


class TimeoutException(TransformException):
    pass


_EXCEPTIONS = {
    UnconnectedError: ConnectivityException,
    UnknownFrameError: LookupException,
    ExtrapolationError: ExtrapolationException,
    ArgumentError: InvalidArgumentException,
}


def rigid_of(transform: Any) -> Rigid:
    """Return a geometry_msgs/Transform as a transform to calculate with."""
    t, r = transform.translation, transform.rotation
    return Rigid((t.x, t.y, t.z), (r.x, r.y, r.z, r.w))


class BufferCore:
    """A buffer of transforms."""

    def __init__(self, cache_time: Any = None) -> None:
        from rclpy.logging import get_logger

        self.tree = TransformTree() if cache_time is None else TransformTree(cache_time.nanoseconds)
        self._logger = get_logger("tf2_buffer")

    def set_transform(self, transform: Any, authority: str) -> None:
        self._set(transform, False)

    def set_transform_static(self, transform: Any, authority: str) -> None:
        self._set(transform, True)

    def _set(self, transform: Any, static: bool) -> None:
        stamp = transform.header.stamp.sec * 10**9 + transform.header.stamp.nanosec
        problem = self.tree.set(
            transform.header.frame_id, transform.child_frame_id, rigid_of(transform.transform), stamp, static
        )
        if problem is not None:
            self._logger.warn(f"TF ignores {problem}")

    def lookup_transform_core(self, target_frame: str, source_frame: str, time: Any) -> Any:
        try:
            found, at = self.tree.lookup(target_frame, source_frame, time.nanoseconds)
        except TransformError as e:
            raise _EXCEPTIONS[type(e)](str(e)) from e
        return stamped(target_frame, source_frame, found, at)

    def lookup_transform_full_core(
        self, target_frame: str, target_time: Any, source_frame: str, source_time: Any, fixed_frame: str
    ) -> Any:
        try:
            first, _ = self.tree.lookup(fixed_frame, source_frame, source_time.nanoseconds)
            second, at = self.tree.lookup(target_frame, fixed_frame, target_time.nanoseconds)
        except TransformError as e:
            raise _EXCEPTIONS[type(e)](str(e)) from e
        return stamped(target_frame, source_frame, first.then(second), at)

    def can_transform_core(self, target_frame: str, source_frame: str, time: Any) -> tuple[bool, str]:
        try:
            self.tree.lookup(target_frame, source_frame, time.nanoseconds)
        except TransformError as e:
            return False, str(e)
        return True, ""

    def can_transform_full_core(
        self, target_frame: str, target_time: Any, source_frame: str, source_time: Any, fixed_frame: str
    ) -> tuple[bool, str]:
        try:
            self.lookup_transform_full_core(target_frame, target_time, source_frame, source_time, fixed_frame)
        except TransformException as e:
            return False, str(e)
        return True, ""

    def clear(self) -> None:
        self.tree.clear()

    def all_frames_as_yaml(self) -> str:
        lines = [f"{child}: \n  parent: '{parent}'\n" for child, parent in sorted(self.tree.parents().items())]
        return "".join(lines) or "[]"

    def all_frames_as_string(self) -> str:
        pairs = sorted(self.tree.parents().items())
        return "".join(f"Frame {child} exists with parent {parent}.\n" for child, parent in pairs)

    def _frameExists(self, frame_id: str) -> bool:
        return frame_id in self.tree.known


def stamped(target: str, source: str, transform: Rigid, time_ns: int) -> Any:
    """Return a geometry_msgs/TransformStamped."""
    from sitaf_ros.current import message

    made = message("geometry_msgs/msg/TransformStamped")(child_frame_id=source)
    made.header.frame_id = target
    made.header.stamp.sec, made.header.stamp.nanosec = divmod(time_ns, 10**9)
    t, r = made.transform.translation, made.transform.rotation
    t.x, t.y, t.z = transform.translation
    r.x, r.y, r.z, r.w = transform.rotation
    return made
