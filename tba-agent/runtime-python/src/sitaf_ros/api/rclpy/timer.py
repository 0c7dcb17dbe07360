"""Timers and rates."""

from __future__ import annotations

import functools
import inspect
from dataclasses import dataclass
from typing import Any

from sitaf_ros.current import note_later_release, system

from .duration import Duration
from .entity import TIMERS, Entity, Order, Work
from .exceptions import InvalidHandle, ROSInterruptException, TimerCancelledError
from .time import Time

SHORTEST_PERIOD_NS = 1_000_000


@dataclass
class TimerInfo:
    expected_call_time: Time
    actual_call_time: Time


class Timer(Entity):
    """A timer; a period of zero counts as 1 ms, because simulated time must pass."""

    def __init__(
        self,
        node: Any,
        callback: Any,
        callback_group: Any,
        timer_period_ns: int,
        clock: Any,
        autostart: bool = True,
    ) -> None:
        super().__init__(node, callback, callback_group)
        if timer_period_ns < 0:
            raise ValueError("timer period must not be negative")
        self.callback, self.clock = callback, clock
        self._period = timer_period_ns
        self._canceled = not autostart
        self._number = system().graph.next_number()
        self._last = system().now_ns
        self._next = self._last + self._step()

    def _step(self) -> int:
        return self._period or SHORTEST_PERIOD_NS

    def order(self) -> Order | None:
        ready = not self._canceled and not self.destroyed and self._next <= system().now_ns
        return (TIMERS, self._number) if ready else None

    def due_ns(self) -> int | None:
        return None if self._canceled or self.destroyed else self._next

    def take(self) -> Work | None:
        now, expected = system().now_ns, self._next
        self._last = now
        # As rcl does: calls that were missed are left out, the phase stays.
        self._next += self._step()
        if self._next < now:
            self._next += -(-(now - self._next) // self._step()) * self._step()
        if self.callback is None:
            return lambda: None
        parameter = _info_parameter(self.callback)
        if parameter:
            note_later_release("TimerInfo for the callback of a timer")
            shift = self.clock.now().nanoseconds - now
            kind = self.clock.clock_type
            info = TimerInfo(
                Time(nanoseconds=expected + shift, clock_type=kind), Time(nanoseconds=now + shift, clock_type=kind)
            )
            return functools.partial(self.callback, **{parameter: info})
        return self.callback

    def cancel(self) -> None:
        self._canceled = True

    def is_canceled(self) -> bool:
        return self._canceled

    def is_ready(self) -> bool:
        return self.order() is not None

    def reset(self) -> None:
        if self.destroyed:
            raise InvalidHandle("cannot use Destroyable because destruction was requested")
        self._canceled = False
        self._next = system().now_ns + self._step()
        self._node._ros_wake()

    @property
    def timer_period_ns(self) -> int:
        return self._period

    @timer_period_ns.setter
    def timer_period_ns(self, value: float) -> None:
        self._period = int(value)

    def time_since_last_call(self) -> int:
        return system().now_ns - self._last

    def time_until_next_call(self) -> int | None:
        return None if self._canceled else self._next - system().now_ns


def _info_parameter(callback: Any) -> str:
    """Return the parameter that is annotated as TimerInfo; empty if there is none."""
    try:
        parameters = inspect.signature(callback).parameters.values()
    except (TypeError, ValueError):
        return ""  # a built-in function without a signature
    return next((p.name for p in parameters if p.annotation is TimerInfo), "")


class Rate:
    """Sleeps until the next multiple of a period."""

    def __init__(self, node: Any, period_ns: int) -> None:
        self._node, self._period = node, period_ns
        self._next = system().now_ns + period_ns
        self._destroyed = False

    def sleep(self) -> None:
        if self._destroyed:
            raise RuntimeError("Rate cannot sleep because it has been destroyed")
        if not self._node.context.ok():
            raise ROSInterruptException
        threads = system().threads
        now = threads.now_ns
        if self._next < now:
            self._next += (now - self._next) // self._period * self._period
        threads.wait(self._next)
        self._next += self._period
        if self._destroyed:
            raise TimerCancelledError

    def destroy(self) -> None:
        self._destroyed = True


def period_ns(seconds: Any) -> int:
    """Return a period in ns, as rclpy rounds it."""
    if isinstance(seconds, Duration):
        return seconds.nanoseconds
    return int(float(seconds) * 1_000_000_000)
