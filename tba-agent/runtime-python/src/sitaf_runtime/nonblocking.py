"""Nonblocking calls. They run on their own thread, so that simulation time passes during the call."""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import TYPE_CHECKING, Generic, TypeVar

from sitaf_runtime.stopwatch import Stopwatch

if TYPE_CHECKING:
    from sitaf_runtime.simulation.session import Simulation

T = TypeVar("T")


class NonblockingCall(Generic[T]):
    """Runs a call on a thread; with a simulation, simulation time passes only while the call waits for it."""

    def __init__(self, stopwatch: Stopwatch, simulation: Simulation | None, call: Callable[[], T]) -> None:
        self._stopwatches = stopwatch
        # That of a step that overlaps others measures its nonblocking call, too.
        self._stopwatch = stopwatch.of_this_thread
        self._time = None if simulation is None else simulation.time
        self._call = call
        self._returned: list[T] = []
        self._raised: BaseException | None = None
        self._thread = threading.Thread(target=self._run, name="call under test", daemon=True)
        if self._time is not None:
            self._time.follow(self._thread)
        self._thread.start()
        if self._time is not None and not self._time.is_driver:
            # The caller is a followed thread, too: one of them runs at a time.
            self._time.await_turn_of(self._thread)

    def _run(self) -> None:
        with self._stopwatches.separate(self._stopwatch):
            self._call_it()

    def _call_it(self) -> None:
        self._stopwatch.start()
        try:
            self._returned.append(self._call())
            self._stopwatch.stop()
        except BaseException as e:
            # The stopwatch keeps running, so the run attributes the exception to the component.
            self._raised = e
        finally:
            if self._time is not None:
                self._time.leave()

    def outcome(self) -> T:
        """Wait for the call and return its value; meanwhile simulation time passes when the call waits for it.

        Raises what the component raises.
        """
        if self._time is not None:
            self._time.pass_until_leaves(self._thread)
        self._thread.join()
        if self._raised is not None:
            raise self._raised
        return self._returned[0]

    def give_up(self) -> None:
        """End a call whose outcome is no longer needed, so that it does not affect the next case.

        Its waits for simulation time raise an exception. Returns when the call has ended.
        """
        if self._time is not None:
            self._time.give_up(self._thread)
        self._thread.join()
