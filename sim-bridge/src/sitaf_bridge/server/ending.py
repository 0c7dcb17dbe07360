"""When the server ends: on a signal, or when its parent goes."""

import os
import signal
import sys
import threading
from collections.abc import Callable

PARENT_POLL_S = 0.5


class Ending:
    """An event that signals, the parent's end and the end of stdin set."""

    def __init__(self) -> None:
        self._event = threading.Event()

    def on_signals(self) -> None:
        """End on SIGTERM and SIGINT. Call from the main thread."""
        for number in (signal.SIGTERM, signal.SIGINT):
            signal.signal(number, lambda *_: self._event.set())

    def with_parent(self, pid: int) -> None:
        """End when the process `pid` is gone."""
        self._watch(lambda: self._wait_for(pid), "parent-watch")

    def with_stdin(self) -> None:
        """End when stdin does: the pipe of a parent that died closes by itself."""

        def drain() -> None:
            while os.read(sys.stdin.fileno(), 4096):
                pass

        self._watch(drain, "stdin-watch")

    def wait(self) -> None:
        """Until one of these happened."""
        self._event.wait()

    def _watch(self, wait: Callable[[], None], name: str) -> None:
        def watch() -> None:
            wait()
            self._event.set()

        threading.Thread(target=watch, name=name, daemon=True).start()

    def _wait_for(self, pid: int) -> None:
        while _is_alive(pid) and not self._event.wait(PARENT_POLL_S):
            pass


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
