"""Standard streams that mark which case printed what.

The first output of each case follows a mark with its number. Output of native code has no mark and is attributed to the
previous case that printed.
"""

from __future__ import annotations

import io
import os
import sys
from contextlib import suppress
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from _typeshed import ReadableBuffer

_MARK = "\x1e"


class _Marked(io.RawIOBase):
    """A descriptor with a mark before the output of each case."""

    def __init__(self, descriptor: int, streams: CaseStreams) -> None:
        super().__init__()
        self._descriptor = descriptor
        self._streams = streams
        self._marked = 0

    def writable(self) -> bool:
        return True

    def fileno(self) -> int:
        return self._descriptor

    def write(self, data: ReadableBuffer, /) -> int:
        text = bytes(data)
        mark = b""
        if text and self._marked != self._streams.current:
            self._marked = self._streams.current
            mark = f"{_MARK}case {self._marked}\n".encode()
        rest = memoryview(mark + text)
        while rest:
            rest = rest[os.write(self._descriptor, rest) :]
        return len(text)


class CaseStreams:
    """Replaces sys.stdout and sys.stderr."""

    def __init__(self) -> None:
        self.current = 0
        self._out = self._stream(1, line_buffering=False)
        self._err = self._stream(2, line_buffering=True)
        sys.stdout = self._out
        sys.stderr = self._err

    def begin(self, no: int) -> None:
        """Attribute the following output to a case; 0 for output that belongs to no case."""
        for stream in (self._out, self._err):
            # The component may have closed the stream, or its reader may have ended.
            with suppress(OSError, ValueError):
                stream.flush()
        self.current = no

    def _stream(self, descriptor: int, *, line_buffering: bool) -> io.TextIOWrapper:
        return io.TextIOWrapper(
            io.BufferedWriter(_Marked(descriptor, self)),
            encoding="utf-8",
            errors="backslashreplace",
            line_buffering=line_buffering,
        )


_installed: CaseStreams | None = None


def install() -> None:
    """Replace sys.stdout and sys.stderr by streams with marks."""
    global _installed  # noqa: PLW0603 - a process runs one suite
    _installed = CaseStreams()


def begin(no: int) -> None:
    """Attribute the following output to a case; 0 for output that belongs to no case."""
    if _installed is not None:
        _installed.begin(no)
