"""Reads what a sanitizer reported when it ended a process of the node; a node may forge or remove it."""

from __future__ import annotations

import os
import re
import stat
import sys
from contextlib import suppress

# The beginning of the reports' paths, as in the options of the sanitizers; the process id follows.
VARIABLE = "SITAF_SANITIZER_REPORTS"
_MOST_BYTES = 1 << 16
_ERROR = re.compile(r"ERROR: AddressSanitizer: ([\w-]{1,60})")
_UNDEFINED = re.compile(r"(\S{1,500}?):(\d{1,9})(?::\d{1,9})?: runtime error: (.{1,300})")
_FRAME = re.compile(r"\s*#\d{1,4} .{1,2000}?\s(\S{1,500}?):(\d{1,9})(?::\d{1,9})?(?: \(.*\))?")
# Sources of the node have the paths that they have in the activity.
_OWN = "activity/"


def of(process: int) -> str:
    """Copy the report of an ended process to standard error.

    Returns the kind of the error and its first line in the node's sources, such as
    `heap-buffer-overflow at scan.cpp:38`; empty if there is no report.
    """
    text = _take(process)
    if not text:
        return ""
    with suppress(OSError, ValueError):
        sys.stderr.write(text)
        sys.stderr.flush()
    return cause(text)


def _take(process: int) -> str:
    prefix = os.environ.get(VARIABLE)
    if not prefix:
        return ""
    path = f"{prefix}.{process}"
    try:
        # Not a link or a pipe, which a node could have made in its place.
        file = os.open(path, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK | os.O_CLOEXEC)
    except OSError:
        return ""
    try:
        if not stat.S_ISREG(os.fstat(file).st_mode):
            return ""
        return os.read(file, _MOST_BYTES).decode(errors="replace")
    except OSError:
        return ""
    finally:
        os.close(file)
        with suppress(OSError):
            os.unlink(path)


def cause(text: str) -> str:
    """Return the kind of the first error in a report and its first line in the node's sources.

    As `SanitizerReport` of the agent, which reads the reports of processes that end with their component.
    """
    kind = place = ""
    for line in text.splitlines():
        if not kind:
            if found := _UNDEFINED.match(line):
                kind, place = found[3].strip(), _place(found)
            elif found := _ERROR.search(line):
                kind = found[1]
        elif not place and (found := _FRAME.fullmatch(line)):
            # The first stack is that of the error; later ones tell where memory came from.
            place = _place(found)
    return f"{kind} at {place}" if place else kind


def _place(found: re.Match[str]) -> str:
    _, own, path = found[1].rpartition(_OWN)
    return f"{path.rpartition('/')[2]}:{found[2]}" if own else ""
