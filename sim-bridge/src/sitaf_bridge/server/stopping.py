"""Stops the server on a signal, or when its parent process ends."""

import os
import signal
import sys
import threading
import time
from collections.abc import Callable
from contextlib import suppress
from queue import Empty, SimpleQueue

PARENT_POLL_S = 0.5
WAKE_S = 1.0


class StopSignal:
    """Waits for a signal, the end of the parent process, or the end of stdin.

    Uses a queue, because a signal handler may interrupt the waiting thread: an Event's lock would be held then, and
    both would deadlock.
    """

    def __init__(self) -> None:
        self._ended: SimpleQueue[None] = SimpleQueue()

    def on_signals(self) -> None:
        """Stop on SIGTERM and SIGINT. Call in the main thread."""
        for number in (signal.SIGTERM, signal.SIGINT):
            signal.signal(number, lambda *_: self._ended.put(None))

    def with_parent(self, pid: int) -> None:
        """Stop when the process `pid` has ended."""

        def poll() -> None:
            while _is_alive(pid):
                time.sleep(PARENT_POLL_S)

        self._watch(poll, "parent-watch")

    def with_stdin(self) -> None:
        """Stop when stdin is closed, which happens automatically when a parent with the pipe dies."""

        def drain() -> None:
            while os.read(sys.stdin.fileno(), 4096):
                pass

        self._watch(drain, "stdin-watch")

    def wait(self) -> None:
        """Wait for one of these events."""
        while True:
            # Handlers run in this thread, but a signal that arrives just before it blocks does not wake it.
            with suppress(Empty):
                self._ended.get(timeout=WAKE_S)
                return

    def _watch(self, wait: Callable[[], None], name: str) -> None:
        def watch() -> None:
            wait()
            self._ended.put(None)

        threading.Thread(target=watch, name=name, daemon=True).start()


def _is_alive(pid: int) -> bool:
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    except PermissionError:
        return True
    # An orphan's former parent may remain as a zombie, which kill() still finds.
    try:
        with open(f"/proc/{pid}/stat", "rb") as stat:
            return stat.read().rpartition(b")")[2].split()[0] != b"Z"
    except OSError:
        return True
