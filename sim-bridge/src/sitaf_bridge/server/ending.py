"""When the server ends: on a signal, or when its parent goes."""

import os
import signal
import sys
import threading
import time
from collections.abc import Callable
from queue import SimpleQueue

PARENT_POLL_S = 0.5


class Ending:
    """What signals, the parent's end and the end of stdin bring about.

    A queue, since a handler may interrupt the very thread that waits: an Event's lock is then held, and the two would
    wait for each other for ever.
    """

    def __init__(self) -> None:
        self._ended: SimpleQueue[None] = SimpleQueue()

    def on_signals(self) -> None:
        """End on SIGTERM and SIGINT. Call from the main thread."""
        for number in (signal.SIGTERM, signal.SIGINT):
            signal.signal(number, lambda *_: self._ended.put(None))

    def with_parent(self, pid: int) -> None:
        """End when the process `pid` is gone."""

        def poll() -> None:
            while _is_alive(pid):
                time.sleep(PARENT_POLL_S)

        self._watch(poll, "parent-watch")

    def with_stdin(self) -> None:
        """End when stdin does: the pipe of a parent that died closes by itself."""

        def drain() -> None:
            while os.read(sys.stdin.fileno(), 4096):
                pass

        self._watch(drain, "stdin-watch")

    def wait(self) -> None:
        """Until one of these happened."""
        self._ended.get()

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
    # An orphan's former parent may linger as a zombie, which kill() still finds.
    try:
        with open(f"/proc/{pid}/stat", "rb") as stat:
            return stat.read().rpartition(b")")[2].split()[0] != b"Z"
    except OSError:
        return True
