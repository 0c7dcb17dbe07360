"""Durations."""

from __future__ import annotations

from typing import Any

from sitaf_ros.current import message

from .constants import S_TO_NS

_LIMIT = 2**63


class Duration:
    def __init__(self, *, seconds: float = 0, nanoseconds: float = 0) -> None:
        total = int(seconds * S_TO_NS) + int(nanoseconds)
        if not -_LIMIT <= total < _LIMIT:
            raise OverflowError("Total nanoseconds value is too large to store in C duration.")
        self._nanoseconds = total

    @property
    def nanoseconds(self) -> int:
        return self._nanoseconds

    def __repr__(self) -> str:
        return f"Duration(nanoseconds={self.nanoseconds})"

    def __str__(self) -> str:
        if self == Infinite:
            return "Infinite"
        return f"{self.nanoseconds} nanoseconds"

    def __hash__(self) -> int:
        return hash(self._nanoseconds)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Duration) and self.nanoseconds == other.nanoseconds

    def _other(self, other: Any) -> int:
        if not isinstance(other, Duration):
            raise TypeError(f"Can't compare duration with object of type: {type(other)}")
        return other.nanoseconds

    def __lt__(self, other: Any) -> bool:
        return self.nanoseconds < self._other(other)

    def __le__(self, other: Any) -> bool:
        return self.nanoseconds <= self._other(other)

    def __gt__(self, other: Any) -> bool:
        return self.nanoseconds > self._other(other)

    def __ge__(self, other: Any) -> bool:
        return self.nanoseconds >= self._other(other)

    def to_msg(self) -> Any:
        seconds, nanoseconds = divmod(self.nanoseconds, S_TO_NS)
        return message("builtin_interfaces/msg/Duration")(sec=seconds, nanosec=nanoseconds)

    @classmethod
    def from_msg(cls, msg: Any) -> Duration:
        if not isinstance(msg, message("builtin_interfaces/msg/Duration")):
            raise TypeError("Must pass a builtin_interfaces.msg.Duration object")
        return cls(seconds=msg.sec, nanoseconds=msg.nanosec)

    def get_c_duration(self) -> Any:
        return self


Infinite = Duration(nanoseconds=_LIMIT - 1)
