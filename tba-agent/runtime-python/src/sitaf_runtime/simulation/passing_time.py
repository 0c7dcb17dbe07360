"""Advances simulation time in pieces that end when the component has something to do.

That is at each of its periods, and when a wait of one of its threads ends. Time is counted in steps since the case
was prepared; only the driver's thread advances it.
"""

from __future__ import annotations

import threading
from collections.abc import Callable

from sitaf_runtime.errors import SimulationError


class PassingTime:
    """The simulation time of a case; `move` advances the world by a number of steps of `timestep_ns` each."""

    def __init__(self, timestep_ns: int, move: Callable[[int], None]) -> None:
        self._timestep_ns = timestep_ns
        self._move_world = move
        self._changed = threading.Condition()
        self._driver = threading.get_ident()
        self._step = 0
        self._waiting: dict[threading.Thread, int] = {}
        self._followed: threading.Thread | None = None
        self._given_up: threading.Thread | None = None
        self._ended = False
        self._period_ns = 0
        self._tick: Callable[[], object] | None = None
        self._begin = 0
        self._count = 1
        self._ticking = False

    @property
    def timestep_ns(self) -> int:
        """The length of a step."""
        return self._timestep_ns

    def pass_steps(self, steps: int) -> None:
        """Advance time by whole steps, in the driver's thread."""
        self._move(steps)

    def steps_in(self, time_ns: int) -> int:
        """Number of steps in a time, rounded up."""
        return max(0, -(-time_ns // self._timestep_ns))

    def restart(self) -> None:
        """Start a case with the calling thread as its driver; waits of the previous case end."""
        with self._changed:
            self._driver = threading.get_ident()
            self._step = 0
            self._tick = None
            self._followed = None
            if self._waiting:
                self._waiting.clear()
                self._changed.notify_all()

    def every(self, period_ns: int, tick: Callable[[], object]) -> None:
        """Call `tick` on the first step at or after each period from now, but not during another tick."""
        if period_ns <= 0:
            raise ValueError(f"the period {period_ns} ns must be above zero")
        self._period_ns, self._tick, self._begin, self._count = period_ns, tick, self._step, 1

    def follow(self, thread: threading.Thread) -> None:
        """Let time pass only while a thread waits for it, until the thread leaves.

        Everything that the thread does then happens at the same simulation time in every run. Call this before the
        thread is started.
        """
        with self._changed:
            self._followed = thread
            self._given_up = None

    def leave(self) -> None:
        """Stop following the calling thread, which calls this at its end."""
        with self._changed:
            if self._followed is threading.current_thread():
                self._followed = None
                self._changed.notify_all()

    def pass_until_thread_leaves(self) -> None:
        """Let time pass until the followed thread leaves; do nothing when no thread is followed."""
        while steps := self._awaited():
            self._move(steps)

    def give_up(self) -> None:
        """Stop following the thread: its current and later waits raise an exception."""
        with self._changed:
            self._given_up = self._followed
            self._followed = None
            self._changed.notify_all()

    def end(self) -> None:
        """End all waits."""
        with self._changed:
            self._ended = True
            self._changed.notify_all()

    def let_pass(self, time_ns: int) -> None:
        """Advance time in the driver's thread; other threads wait until the driver has advanced it."""
        steps = self.steps_in(time_ns)
        if steps == 0:
            return
        if threading.get_ident() == self._driver:
            self._move(steps)
        else:
            self._await(steps)

    def _move(self, steps: int) -> None:
        end = self._step + steps
        while self._step < end:
            self._await_followed()
            stops = [end, *(target for target in list(self._waiting.values()) if target > self._step)]
            due = self._next_tick()
            stop = min(stops if due is None else [*stops, due])
            self._move_world(stop - self._step)
            with self._changed:
                self._step = stop
                self._waiting = {thread: target for thread, target in self._waiting.items() if target > stop}
                self._changed.notify_all()
            self._tick_if_due()
        self._await_followed()

    def _next_tick(self) -> int | None:
        if self._tick is None or self._ticking:
            return None
        # Ticks during a sleep of the component itself are skipped.
        while self._at() <= self._step:
            self._count += 1
        return self._at()

    def _tick_if_due(self) -> None:
        if self._tick is None or self._ticking or self._at() != self._step:
            return
        self._count += 1
        self._ticking = True
        try:
            self._tick()
        finally:
            self._ticking = False

    def _at(self) -> int:
        return self._begin + -(-self._count * self._period_ns // self._timestep_ns)

    def _await(self, steps: int) -> None:
        me = threading.current_thread()
        with self._changed:
            self._waiting[me] = self._step + steps
            self._changed.notify_all()
            while me in self._waiting and me is not self._given_up and not self._ended:
                self._changed.wait()
            if me is self._given_up:
                self._waiting.pop(me, None)
                raise SimulationError("the case has ended, and its simulation time no longer advances")

    def _await_followed(self) -> None:
        """Wait until the followed thread waits for simulation time or has left."""
        if self._followed is None:
            return
        with self._changed:
            while self._followed is not None and self._followed not in self._waiting:
                self._changed.wait()

    def _awaited(self) -> int:
        """Steps that the followed thread waits for; 0 when it has left."""
        self._await_followed()
        thread = self._followed
        return 0 if thread is None else self._waiting[thread] - self._step
