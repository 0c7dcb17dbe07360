"""Runs the threads of nodes one at a time, in a defined order, over simulated time.

Each is a thread of the operating system that runs only while it has the baton. It passes the baton on when it waits.
"""

from __future__ import annotations

import _thread
import sys
import threading
from collections import deque
from collections.abc import Callable
from typing import Any

# Taken before anything is replaced by a simulated version.
_allocate_lock = _thread.allocate_lock
_get_ident = _thread.get_ident
_start_new_thread = _thread.start_new_thread

POLLS_AT_ONE_INSTANT = 500
POLL_NS = 1_000_000
WAITS_AT_THE_END = 1000


class CaseEnded(BaseException):
    """Ends a thread of a node that still waits when the case has ended."""


class NodeThread:
    """A thread of a node: the main function, or one that the node started."""

    def __init__(self, number: int, name: str) -> None:
        self.number = number
        self.name = name
        self.baton = _allocate_lock()
        self.baton.acquire()
        self.ident = 0
        self.waiting = False
        self.deadline_ns: int | None = None
        self.timed_out = False
        self.poll: Callable[[], bool] | None = None
        self.finished = False
        self.joining: list[NodeThread] = []


class NodeThreads:
    """The threads of a case that have not ended, and its time."""

    def __init__(self) -> None:
        self.now_ns = 0
        self.ending = False
        self.all: list[NodeThread] = []
        self._by_ident: dict[int, NodeThread] = {}
        self._ready: deque[NodeThread] = deque()
        self._driver = _allocate_lock()
        self._driver.acquire()
        self._polls = 0
        self._polled_at = 0
        self._late_waits = 0
        self._started = 0
        self.slowest_polls = 0

    def is_node_thread(self) -> bool:
        """Tell whether the caller is a thread of a node."""
        return _get_ident() in self._by_ident

    def current(self) -> NodeThread:
        """Return the calling thread."""
        return self._by_ident[_get_ident()]

    def start(self, name: str, run: Callable[[], object], begin: Callable[[int], object] | None = None) -> NodeThread:
        """Start a thread; it runs when those before it wait. `begin` gets its identifier before it runs."""
        self._started += 1
        thread = NodeThread(self._started, name)
        self.all.append(thread)
        registered = _allocate_lock()
        registered.acquire()

        def carry() -> None:
            thread.ident = _get_ident()
            self._by_ident[thread.ident] = thread
            registered.release()
            thread.baton.acquire()
            trace = threading.gettrace()
            if trace is not None:
                sys.settrace(trace)  # coverage.py measures threads by it
            try:
                if not self.ending:
                    run()
            except CaseEnded:
                pass  # the regular end of a thread that waits at the end of the case
            finally:
                self._finish(thread)

        _start_new_thread(carry, ())
        registered.acquire()
        if begin is not None:
            begin(thread.ident)
        self._ready.append(thread)
        return thread

    def _finish(self, thread: NodeThread) -> None:
        thread.finished = True
        del self._by_ident[thread.ident]
        self.all.remove(thread)
        for other in thread.joining:
            self.wake(other)
        self._pass_on()

    def _pass_on(self) -> None:
        (self._ready.popleft().baton if self._ready else self._driver).release()

    def wait(
        self, deadline_ns: int | None, poll: Callable[[], bool] | None = None, returns_at_end: bool = False
    ) -> bool:
        """Wait until `wake`, until `poll` is true when nothing else runs, or until the deadline; return False then."""
        me = self.current()
        if self.ending:
            return self._wait_at_end(deadline_ns, returns_at_end)
        if deadline_ns is not None and deadline_ns <= self.now_ns:
            deadline_ns = self.now_ns
        me.waiting, me.deadline_ns, me.timed_out, me.poll = True, deadline_ns, False, poll
        if deadline_ns == self.now_ns:
            # A wait of no time lets the others run first.
            me.waiting, me.timed_out = False, True
            self._ready.append(me)
        self._switch(me)
        if self.ending and deadline_ns is None and not returns_at_end:
            raise CaseEnded
        return not me.timed_out

    def _wait_at_end(self, deadline_ns: int | None, returns_at_end: bool) -> bool:
        self._late_waits += 1
        if (deadline_ns is None and not returns_at_end) or self._late_waits > WAITS_AT_THE_END:
            raise CaseEnded
        if self._ready:
            me = self.current()
            self._ready.append(me)
            self._switch(me)
        return False

    def _switch(self, me: NodeThread) -> None:
        if self._ready and self._ready[0] is me:
            self._ready.popleft()
            return
        self._pass_on()
        me.baton.acquire()

    def wake(self, thread: NodeThread) -> None:
        """End the wait of a thread; it runs after those that are ready."""
        if thread.waiting:
            thread.waiting = False
            thread.poll = None
            self._ready.append(thread)

    def poll(self) -> None:
        """Count a look at the clock or at a queue without waiting: a loop of these takes simulated time."""
        if self._polled_at != self.now_ns:
            self._polled_at, self._polls = self.now_ns, 0
        self._polls += 1
        if self._polls > POLLS_AT_ONE_INSTANT:
            self.slowest_polls += 1
            self._polls = 0
            self.wait(self.now_ns + POLL_NS)

    def join(self, thread: NodeThread, deadline_ns: int | None) -> None:
        """Wait until a thread has ended."""
        while not thread.finished:
            thread.joining.append(self.current())
            if not self.wait_for_others(deadline_ns):
                return

    def wait_for_others(self, deadline_ns: int | None) -> bool:
        """Wait for what another thread does; at the end of the case, only as long as another one can run."""
        if self.ending:
            if not self._ready and deadline_ns is None:
                raise CaseEnded
            self._wait_at_end(deadline_ns, returns_at_end=True)
            return deadline_ns is None
        return self.wait(deadline_ns, returns_at_end=True) or self.ending

    def run_ready(self, patience_s: float = -1) -> bool:
        """Called by the driver: run threads until all wait; return False if one did not within `patience_s`."""
        while self._ready or self._wake_polled():
            self._ready.popleft().baton.release()
            if not self._driver.acquire(True, patience_s):
                return False
        return True

    def _wake_polled(self) -> bool:
        for thread in list(self.all):
            if thread.waiting and thread.poll is not None and thread.poll():
                self.wake(thread)
        return bool(self._ready)

    def next_deadline_ns(self) -> int | None:
        """Return when the first wait ends."""
        return min((t.deadline_ns for t in self.all if t.waiting and t.deadline_ns is not None), default=None)

    def advance_to(self, time_ns: int) -> None:
        """Set the time and make the threads ready whose waits end by then, in the order of their deadlines."""
        self.now_ns = max(self.now_ns, time_ns)
        due = [t for t in self.all if t.waiting and t.deadline_ns is not None and t.deadline_ns <= self.now_ns]
        for thread in sorted(due, key=lambda t: (t.deadline_ns, t.number)):
            thread.timed_out = True
            self.wake(thread)

    def end(self, patience_s: float) -> bool:
        """End all waits and run what the nodes do then; return False if a thread did not stop in time."""
        self.ending = True
        for thread in list(self.all):
            if thread.waiting:
                thread.timed_out = True
                self.wake(thread)
        return self.run_ready(patience_s)

    def live(self) -> list[Any]:
        """Return the threads that have not ended."""
        return list(self.all)
