"""Measures calls of the component."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from threading import get_ident

_NANOS_PER_MICRO = 1000.0


class Stopwatch:
    """Measures one call with the monotonic clock, and separately its time in virtual hardware and in stubs.

    Only the thread that started the stopwatch is measured; other threads of the component are not part of the call.
    """

    __slots__ = ("_before_call", "_began", "_called", "_hardware", "_others", "_owner", "_stub", "_total")

    def __init__(self) -> None:
        self._before_call: Callable[[], None] | None = None
        self._owner = 0
        self._called = False
        # Stopwatches of steps that overlap, by the thread of the call.
        self._others: dict[int, Stopwatch] = {}
        self._began = self._total = self._hardware = self._stub = 0

    def start(self) -> None:
        """Start a new measurement."""
        if self._before_call is not None:
            self._before_call()
        self._total = self._hardware = self._stub = 0
        self._called = True
        self._owner = get_ident()
        self._began = time.perf_counter_ns()

    def stop(self) -> None:
        """End the measurement. Raises RuntimeError when none is running."""
        now = time.perf_counter_ns()
        if not self._owner:
            raise RuntimeError("the stopwatch is stopped before it was started")
        self._total = now - self._began
        self._owner = 0

    @contextmanager
    def separate(self, own: Stopwatch) -> Iterator[None]:
        """In this context, the calling thread has a stopwatch of its own."""
        if own is self:
            yield
            return
        self._others[get_ident()] = own
        try:
            yield
        finally:
            del self._others[get_ident()]

    @property
    def of_this_thread(self) -> Stopwatch:
        """The stopwatch of the calling thread: this one, unless it has its own."""
        return self._others.get(get_ident(), self) if self._others else self

    def before_call(self, action: Callable[[], None]) -> None:
        """Add what runs before each measurement, outside of the measured time."""
        earlier = self._before_call
        if earlier is None:
            self._before_call = action
            return

        def both() -> None:
            earlier()
            action()

        self._before_call = both

    def reset(self) -> None:
        """Clear the measurement."""
        self._owner = 0
        self._called = False
        self._total = self._hardware = self._stub = 0

    @property
    def is_running(self) -> bool:
        """Whether a call is being measured. Then an exception comes from the component."""
        return self._owner != 0

    @property
    def was_started(self) -> bool:
        """Whether a call was started since the last reset."""
        return self._called

    @contextmanager
    def in_hardware(self) -> Iterator[None]:
        """Count the time in this context as spent in virtual hardware."""
        entered = time.perf_counter_ns()
        try:
            yield
        finally:
            self.leave_hardware(entered)

    def leave_hardware(self, entered: int) -> None:
        """Count the time since a value of `time.perf_counter_ns` as spent in virtual hardware."""
        if self._owner == get_ident():
            self._hardware += time.perf_counter_ns() - entered
        elif self._others:
            other = self.of_this_thread
            if other is not self:
                other.leave_hardware(entered)

    def leave_stub(self, entered: int) -> None:
        """Count the time since a value of `time.perf_counter_ns` as spent in a stub."""
        if self._owner == get_ident():
            self._stub += time.perf_counter_ns() - entered
        elif self._others:
            other = self.of_this_thread
            if other is not self:
                other.leave_stub(entered)

    @property
    def component_us(self) -> float:
        """Time of the call in microseconds, without virtual hardware and stubs."""
        return max(0, self._total - self._hardware - self._stub) / _NANOS_PER_MICRO

    @property
    def hardware_us(self) -> float:
        """Time spent in virtual hardware, in microseconds."""
        return self._hardware / _NANOS_PER_MICRO

    @property
    def stub_us(self) -> float:
        """Time spent in stubs, in microseconds."""
        return self._stub / _NANOS_PER_MICRO
