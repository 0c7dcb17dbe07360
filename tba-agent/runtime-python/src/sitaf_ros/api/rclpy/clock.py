"""Clocks; all of them show simulation time, with different zeros."""

from __future__ import annotations

import enum
from typing import Any

from sitaf_ros.current import node_threads
from sitaf_ros.current import system as current_system
from sitaf_ros.simulated_time import wall_ns

from .clock_type import ClockType
from .duration import Duration
from .exceptions import NotInitializedException
from .time import Time

__all__ = ["Clock", "ClockChange", "ClockType", "JumpHandle", "JumpThreshold", "ROSClock", "TimeJump"]


class ClockChange(enum.IntEnum):
    ROS_TIME_NO_CHANGE = 1
    ROS_TIME_ACTIVATED = 2
    ROS_TIME_DEACTIVATED = 3
    SYSTEM_TIME_NO_CHANGE = 4


class JumpThreshold:
    def __init__(self, *, min_forward: Any, min_backward: Any, on_clock_change: bool = True) -> None:
        if min_forward is None and min_backward is None and not on_clock_change:
            raise ValueError("At least one jump threshold must be enabled")
        self.min_forward, self.min_backward, self.on_clock_change = min_forward, min_backward, on_clock_change


class TimeJump:
    def __init__(self, clock_change: ClockChange, delta: Duration) -> None:
        self.clock_change, self.delta = clock_change, delta


class JumpHandle:
    """Simulation time never jumps, so a jump callback is never called."""

    def __init__(self, **_: Any) -> None:
        pass

    def unregister(self) -> None:
        pass

    def __enter__(self) -> JumpHandle:
        return self

    def __exit__(self, *_: object) -> None:
        pass


class Clock:
    def __new__(cls, *, clock_type: ClockType = ClockType.SYSTEM_TIME) -> Clock:
        if not isinstance(clock_type, ClockType):
            raise TypeError("Clock type must be a ClockType enum")
        return object.__new__(ROSClock if clock_type is ClockType.ROS_TIME else cls)

    def __init__(self, *, clock_type: ClockType = ClockType.SYSTEM_TIME) -> None:
        self._clock_type = clock_type

    @property
    def clock_type(self) -> ClockType:
        return self._clock_type

    def __repr__(self) -> str:
        return f"Clock(clock_type={self.clock_type.name})"

    def _now_ns(self) -> int:
        return wall_ns()

    def now(self) -> Time:
        threads = node_threads()
        if threads is not None and not threads.ending:
            threads.poll()
        return Time(nanoseconds=self._now_ns(), clock_type=self.clock_type)

    def create_jump_callback(
        self, threshold: JumpThreshold, *, pre_callback: Any = None, post_callback: Any = None
    ) -> JumpHandle:
        if pre_callback is None and post_callback is None:
            raise ValueError("One of pre_callback or post_callback must be callable")
        return JumpHandle()

    def sleep_until(self, until: Time, context: Any = None) -> bool:
        if until.clock_type != self.clock_type:
            raise ValueError("until's clock type does not match this clock's type")
        from . import utilities

        context = utilities.get_default_context() if context is None else context
        if not context.ok():
            raise NotInitializedException
        threads = current_system().threads
        delay = until.nanoseconds - self._now_ns()
        if delay > 0:
            threads.wait(threads.now_ns + delay)
        return context.ok()

    def sleep_for(self, rel_time: Duration, context: Any = None) -> bool:
        return self.sleep_until(Time(nanoseconds=self._now_ns(), clock_type=self.clock_type) + rel_time, context)


class ROSClock(Clock):
    def __new__(cls, **_: Any) -> ROSClock:
        return object.__new__(cls)

    def __init__(self, *, clock_type: ClockType = ClockType.ROS_TIME) -> None:
        super().__init__(clock_type=ClockType.ROS_TIME)
        self._simulated = current_system().settings.use_sim_time

    @property
    def ros_time_is_active(self) -> bool:
        return self._simulated

    def _set_ros_time_is_active(self, enabled: bool) -> None:
        self._simulated = enabled

    def _now_ns(self) -> int:
        return current_system().now_ns if self._simulated else wall_ns()

    def set_ros_time_override(self, time: Time) -> None:
        raise NotImplementedError("the time of a test case is set by its simulation")
