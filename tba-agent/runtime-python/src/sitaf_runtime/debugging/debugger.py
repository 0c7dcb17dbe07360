"""A pdb that knows which code belongs to the component."""

from __future__ import annotations

import os
import pdb
import select
import signal
import socket
import sys
from collections.abc import Callable
from types import FrameType
from typing import IO, Any

from sitaf_runtime.thrown import is_the_users

# How often to look whether another debugger has attached.
_POLL_S = 0.1
_SITAF = ("sitaf_runtime", "sitaf_harness")


def _is_sitafs(filename: str) -> bool:
    return any(folder in _SITAF for folder in filename.split(os.sep)[:-1])


class ComponentDebugger(pdb.Pdb):
    """Stops in the component, never in SITAF's own code. Leaving it lets the test continue."""

    def __init__(self, reader: IO[str], writer: IO[str]) -> None:
        super().__init__(stdin=reader, stdout=writer, readrc=False)
        self._left = False

    @classmethod
    def connected(cls, path: str, attached: Callable[[], bool]) -> ComponentDebugger | None:
        """Wait until a terminal connects to the socket at a path; None if another debugger has attached before."""
        with socket.socket(socket.AF_UNIX, socket.SOCK_STREAM) as listening:
            # Renamed when it accepts connections, so that nobody connects too early.
            early = f"{path}~"
            listening.bind(early)
            listening.listen(1)
            os.rename(early, path)
            while not select.select([listening], [], [], _POLL_S)[0]:
                if attached():
                    return None
            terminal, _ = listening.accept()
        # The terminal sends this signal for Ctrl-C; pdb handles it while the component runs.
        signal.signal(signal.SIGINT, signal.SIG_IGN)
        reader = terminal.makefile("r", encoding="utf-8", errors="replace")
        writer = terminal.makefile("w", encoding="utf-8", errors="replace")
        return cls(reader, writer)

    def stop_in_next_call(self) -> None:
        """Stop in the first frame of the component that this thread enters."""
        if not self._left:
            sys.settrace(self._enter)

    def _enter(self, frame: FrameType, event: str, _argument: object) -> Any:
        if event != "call" or not is_the_users(frame.f_code.co_filename):
            return None
        self.reset()
        # The frames of the test driver are not traced.
        self.botframe = frame.f_back
        self.set_step()
        sys.settrace(self.trace_dispatch)
        # The event of the first line follows.
        return self.trace_dispatch

    def stop_here(self, frame: FrameType) -> bool:
        """Whether to stop in a frame; never in SITAF's own."""
        return not _is_sitafs(frame.f_code.co_filename) and super().stop_here(frame)

    def interaction(self, frame: FrameType | None, traceback: Any) -> None:
        """Talk to the terminal; when it is gone, let the test continue."""
        try:
            super().interaction(frame, traceback)
        except (OSError, ValueError):
            self._leave()

    def do_quit(self, arg: str) -> bool:
        """Leave the debugger; the test continues."""
        self._leave()
        return True

    do_q = do_exit = do_quit

    def do_EOF(self, arg: str) -> bool:  # noqa: N802
        """Leave the debugger; the test continues."""
        return self.do_quit(arg)

    def _leave(self) -> None:
        self._left = True
        self.clear_all_breaks()
        self.set_continue()
