"""Points in time."""

from __future__ import annotations

from typing import Any

from sitaf_ros.current import message

from .clock_type import ClockType
from .constants import S_TO_NS
from .duration import Duration

_LIMIT = 2**63
CONVERSION_CONSTANT = 10**9


class Time:
    def __init__(
        self, *, seconds: float = 0, nanoseconds: float = 0, clock_type: ClockType = ClockType.SYSTEM_TIME
    ) -> None:
        if not isinstance(clock_type, ClockType):
            raise TypeError("Clock type must be a ClockType enum")
        if seconds < 0 or nanoseconds < 0:
            raise ValueError("Seconds and nanoseconds value must not be negative")
        total = int(seconds * S_TO_NS) + int(nanoseconds)
        if total >= _LIMIT:
            raise OverflowError("Total nanoseconds value is too large to store in C time point.")
        self._nanoseconds, self._clock_type = total, clock_type

    @property
    def nanoseconds(self) -> int:
        return self._nanoseconds

    def seconds_nanoseconds(self) -> tuple[int, int]:
        return self.nanoseconds // S_TO_NS, self.nanoseconds % S_TO_NS

    @property
    def clock_type(self) -> ClockType:
        return self._clock_type

    def __repr__(self) -> str:
        return f"Time(nanoseconds={self.nanoseconds}, clock_type={self.clock_type.name})"

    def __hash__(self) -> int:
        return hash((self._nanoseconds, self._clock_type))

    def __add__(self, other: Any) -> Any:
        if not isinstance(other, Duration):
            return NotImplemented
        try:
            return Time(nanoseconds=self.nanoseconds + other.nanoseconds, clock_type=self.clock_type)
        except OverflowError as e:
            raise OverflowError("Addition leads to overflow in C storage.") from e

    __radd__ = __add__

    def __sub__(self, other: Any) -> Any:
        if isinstance(other, Time):
            if self.clock_type != other.clock_type:
                raise TypeError("Can't subtract times with different clock types")
            return Duration(nanoseconds=self.nanoseconds - other.nanoseconds)
        if isinstance(other, Duration):
            try:
                return Time(nanoseconds=self.nanoseconds - other.nanoseconds, clock_type=self.clock_type)
            except ValueError as e:
                raise ValueError("Subtraction leads to negative time.") from e
        return NotImplemented

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Time) and self.nanoseconds == self._same_clock(other)

    def _same_clock(self, other: Any) -> int:
        if not isinstance(other, Time):
            raise TypeError(f"Can't compare time with object of type: {type(other)}")
        if self.clock_type != other.clock_type:
            raise TypeError("Can't compare times with different clock types")
        return other.nanoseconds

    def __lt__(self, other: Any) -> bool:
        return self.nanoseconds < self._same_clock(other)

    def __le__(self, other: Any) -> bool:
        return self.nanoseconds <= self._same_clock(other)

    def __gt__(self, other: Any) -> bool:
        return self.nanoseconds > self._same_clock(other)

    def __ge__(self, other: Any) -> bool:
        return self.nanoseconds >= self._same_clock(other)

    def to_msg(self) -> Any:
        seconds, nanoseconds = self.seconds_nanoseconds()
        return message("builtin_interfaces/msg/Time")(sec=seconds, nanosec=nanoseconds)

    @classmethod
    def from_msg(cls, msg: Any, clock_type: ClockType = ClockType.ROS_TIME) -> Time:
        if not isinstance(msg, message("builtin_interfaces/msg/Time")):
            raise TypeError("Must pass a builtin_interfaces.msg.Time object")
        return cls(seconds=msg.sec, nanoseconds=msg.nanosec, clock_type=clock_type)
