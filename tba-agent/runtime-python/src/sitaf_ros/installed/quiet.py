"""Tells when all threads of this process rest, so that the nodes have done what there was to do."""

from __future__ import annotations

import os
import threading
import time
from contextlib import suppress

_LOOK_S = 0.000_3
# What the clocks themselves take.
_NOISE_NS = 3_000
_RESTING = (b"S", b"I")


class Quiet:
    """Looks at the threads of this process other than the caller's.

    A thread that waits for Python's lock sleeps, too; that is why they rest only when they have used no processor time
    while the caller slept, and so had left the lock to others.
    """

    def __init__(self) -> None:
        self._states: dict[str, int] = {}

    def wait(self, at_most_s: float) -> bool:
        """Wait until the other threads rest; return whether that came in time."""
        end_s = time.monotonic() + at_most_s
        while True:
            before_ns = _used_by_others_ns()
            time.sleep(_LOOK_S)
            if _used_by_others_ns() - before_ns <= _NOISE_NS and not self._one_runs():
                return True
            if time.monotonic() > end_s:
                return False

    def _one_runs(self) -> bool:
        """Whether a thread runs, or is ready to run on a busy machine."""
        own = str(threading.get_native_id())
        threads = set(os.listdir("/proc/self/task"))
        for gone in self._states.keys() - threads:
            self._close(gone)
        for thread in threads - {own}:
            try:
                if thread not in self._states:
                    self._states[thread] = os.open(f"/proc/self/task/{thread}/stat", os.O_RDONLY | os.O_CLOEXEC)
                # Behind the name, which may hold anything.
                if os.pread(self._states[thread], 512, 0).rpartition(b") ")[2][:1] not in _RESTING:
                    return True
            except OSError:
                self._close(thread)  # it has just ended
        return False

    def _close(self, thread: str) -> None:
        file = self._states.pop(thread, None)
        if file is not None:
            with suppress(OSError):
                os.close(file)

    def close(self) -> None:
        """Close all files."""
        for thread in list(self._states):
            self._close(thread)


def _used_by_others_ns() -> int:
    return time.process_time_ns() - time.thread_time_ns()
