"""The standard input of a node: a pseudo-terminal with the lines of the case."""

from __future__ import annotations

import io
import os
import select
from collections import deque
from collections.abc import Iterable

from sitaf_ros.current import node_threads

_real_select = select.select


class NodeInput(io.TextIOBase):
    """Gives one line after the other; a read beyond the last waits until the case ends."""

    def __init__(self, lines: Iterable[str]) -> None:
        self._lines = deque(lines)
        self._is_without_lines = not self._lines
        self.lacks_lines = False
        """Whether the node waited for a line, and the activity names none."""
        self._fds: tuple[int, int] | None = None
        self._text = ""

    def _open(self) -> tuple[int, int]:
        if self._fds is None:
            try:
                self._fds = os.openpty()
            except OSError:
                read, write = os.pipe()  # a sandbox without terminals
                self._fds = (write, read)
        return self._fds

    def fileno(self) -> int:
        """Return the descriptor of the terminal."""
        return self._open()[1]

    def isatty(self) -> bool:
        """Tell that it is a terminal."""
        return os.isatty(self.fileno())

    def readable(self) -> bool:
        """Tell that it can be read."""
        return True

    @property
    def has_text(self) -> bool:
        """Tell whether characters were taken from the terminal and not yet read."""
        return bool(self._text)

    def feed(self) -> bool:
        """Put the next line into the terminal if it is empty; return whether something can be read."""
        return self.has_text or self._fed()

    def _fed(self) -> bool:
        master, slave = self._open()
        if _real_select([slave], [], [], 0)[0]:
            return True
        if not self._lines:
            return False
        os.write(master, f"{self._lines.popleft()}\n".encode())
        return bool(_real_select([slave], [], [], 1)[0])

    def _more(self) -> None:
        threads = node_threads()
        if threads is not None:
            while not self._fed():
                self.lacks_lines = self._is_without_lines
                threads.wait(None, poll=self._fed)
        data = os.read(self.fileno(), 4096)
        if not data:
            raise EOFError("the input has ended")
        self._text += data.decode(errors="replace").replace("\r\n", "\n")

    def read(self, size: int | None = -1) -> str:
        """Read so many characters; without a number, one line at a time until the case ends."""
        wanted = 2**62 if size is None or size < 0 else size
        while len(self._text) < wanted:
            self._more()
        text, self._text = self._text[:wanted], self._text[wanted:]
        return text

    def readline(self, size: int = -1) -> str:  # type: ignore[override]
        """Read a line."""
        while "\n" not in self._text and (size < 0 or len(self._text) < size):
            self._more()
        end = self._text.index("\n") + 1 if "\n" in self._text else len(self._text)
        end = end if size < 0 else min(end, size)
        text, self._text = self._text[:end], self._text[end:]
        return text
