"""Advances simulation time in pieces that end when the component has something to do.

That is at each of its periods, and when a wait of one of its threads ends. Time is counted in steps since the case
was prepared; only the driver's thread advances it.

Followed threads make this deterministic: time advances only while each of them waits for it, and those that continue
at the same step do so one after the other, in the order in which they were followed, each until it waits again or
leaves.
"""

from __future__ import annotations

import threading
from collections.abc import Callable
from math import inf

from sitaf_runtime.errors import SimulationError


class PassingTime:
    """The simulation time of a case; `move` advances the world by a number of steps of `timestep_ns` each."""

    def __init__(self, timestep_ns: int, move: Callable[[int], None]) -> None:
        self._timestep_ns = timestep_ns
        self._move_world = move
        self._changed = threading.Condition()
        self._driver = threading.get_ident()
        self._step = 0
        # The step at which each waiting thread continues; without end until another thread leaves.
        self._waiting: dict[threading.Thread, float] = {}
        # In the order of their beginning.
        self._followed: list[threading.Thread] = []
        self._given_up: set[threading.Thread] = set()
        # The thread that waits until the key leaves.
        self._joining: dict[threading.Thread, threading.Thread] = {}
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
            self._followed = []
            self._joining.clear()
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
            self._followed = [*self._followed, thread]

    def leave(self) -> None:
        """Stop following the calling thread, which calls this at its end."""
        me = threading.current_thread()
        with self._changed:
            self._given_up.discard(me)
            self._unfollow(me)

    @property
    def is_driver(self) -> bool:
        """Whether the calling thread is the one that advances time."""
        return threading.get_ident() == self._driver

    def pass_until_leaves(self, thread: threading.Thread) -> None:
        """Wait until a followed thread leaves, or has left; in the driver's thread time passes meanwhile."""
        if self.is_driver:
            self.pass_until(thread, lambda: False)
        else:
            self._join(thread)

    def pass_until(self, thread: threading.Thread, reached: Callable[[], bool]) -> None:
        """Let time pass, in the driver's thread, until a followed thread has reached something or has left."""
        while (steps := self._until_next(thread)) and not reached():
            self._move(steps)

    def await_turn_of(self, thread: threading.Thread) -> None:
        """Wait in real time until a followed thread waits for simulation time or has left."""
        with self._changed:
            while thread in self._followed and thread not in self._waiting:
                self._changed.wait()

    def give_up(self, thread: threading.Thread) -> None:
        """Stop following a thread: its current and later waits raise an exception."""
        with self._changed:
            if thread in self._followed:
                self._given_up.add(thread)
                self._unfollow(thread)

    def _unfollow(self, thread: threading.Thread) -> None:
        if thread in self._followed:
            self._followed = [other for other in self._followed if other is not thread]
            joiner = self._joining.pop(thread, None)
            if joiner is not None:
                self._waiting.pop(joiner, None)
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
            stop = int(min(stops if due is None else [*stops, due]))
            self._move_world(stop - self._step)
            with self._changed:
                self._step = stop
                self._continue_due()
            self._tick_if_due()
        self._await_followed()

    def _continue_due(self) -> None:
        """End the waits that are over; followed threads continue one after the other."""
        for thread in [t for t, target in self._waiting.items() if target <= self._step and t not in self._followed]:
            del self._waiting[thread]
        self._changed.notify_all()
        for thread in self._followed:
            if self._waiting.get(thread, inf) <= self._step:
                del self._waiting[thread]
                self._changed.notify_all()
                self._await_all()

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
        with self._changed:
            self._waiting[threading.current_thread()] = self._step + steps
            self._wait_until_removed()

    def _join(self, other: threading.Thread) -> None:
        """Wait until another thread leaves."""
        me = threading.current_thread()
        with self._changed:
            if other in self._followed:
                self._joining[other] = me
                self._waiting[me] = inf
                self._wait_until_removed()

    def _wait_until_removed(self) -> None:
        me = threading.current_thread()
        self._changed.notify_all()
        while me in self._waiting and me not in self._given_up and not self._ended:
            self._changed.wait()
        if me in self._given_up:
            self._waiting.pop(me, None)
            raise SimulationError("the case has ended, and its simulation time no longer advances")

    def _await_followed(self) -> None:
        """Wait until each followed thread waits for simulation time or has left."""
        if not self._followed:
            return
        with self._changed:
            self._await_all()

    def _await_all(self) -> None:
        while any(thread not in self._waiting for thread in self._followed):
            self._changed.wait()

    def _until_next(self, thread: threading.Thread) -> int:
        """Steps until the first followed thread continues; 0 when this one has left."""
        with self._changed:
            self._await_all()
            if thread not in self._followed:
                return 0
            return int(min(self._waiting[each] for each in self._followed)) - self._step
