"""The descriptor that the agent opens for results, instead of a file.

Each line starts with its number and a token that the agent wrote to standard input, so that output of the component is
not mistaken for a result.
"""

import fcntl
import os
import re
from collections.abc import Sequence
from contextlib import suppress
from itertools import pairwise
from typing import NamedTuple

from sitaf_runtime.errors import CannotRunError

_NAMED = re.compile("fd:([0-9]{1,4})")
_MAX_TOKEN_LENGTH = 128
_INPUT = 0
# Higher than the numbers that programs usually use.
_LOWEST_DESCRIPTOR = 64
# Large, so that a fast component rarely waits for the agent; the system may limit it.
_PIPE_BYTES = 1 << 20


class Channel(NamedTuple):
    """The descriptor, and the token for its lines."""

    descriptor: int
    token: str


_held: list[Channel] = []


def is_named(results: object) -> bool:
    """Whether `--results` names a descriptor, such as `fd:3`."""
    return _NAMED.fullmatch(str(results)) is not None


def hold(arguments: Sequence[str]) -> None:
    """Take descriptor and token before any code of the component is loaded. Raises CannotRunError."""
    for option, value in pairwise(arguments):
        if option == "--results" and is_named(value):
            _held.append(_open(value))
            return


def forget() -> None:
    """Close the descriptor, in a process that was forked to run code of the component."""
    while _held:
        os.close(_held.pop().descriptor)


def take(results: object) -> Channel:
    """Return the channel of `hold`, otherwise open it now. Raises CannotRunError when there is none."""
    return _held.pop() if _held else _open(str(results))


def _open(results: str) -> Channel:
    token = _token()
    if not token:
        raise CannotRunError(f"--results {results}: standard input holds no line with a token")
    descriptor = int(results.removeprefix("fd:"))
    try:
        own = fcntl.fcntl(descriptor, fcntl.F_DUPFD_CLOEXEC, _LOWEST_DESCRIPTOR)
    except OSError as e:
        raise CannotRunError(f"--results {results}: there is no such open descriptor") from e
    os.close(descriptor)
    with suppress(OSError, AttributeError):
        fcntl.fcntl(own, fcntl.F_SETPIPE_SZ, _PIPE_BYTES)
    return Channel(own, token)


def _token() -> str:
    """Read one line of standard input; the input after it belongs to the component."""
    line = b""
    while len(line) <= _MAX_TOKEN_LENGTH:
        c = os.read(_INPUT, 1)
        if c == b"\n":
            return line.decode("ascii", "replace")
        if not c:
            break
        line += c
    return ""
