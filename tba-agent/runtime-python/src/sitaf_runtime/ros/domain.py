"""Keeps the process of the node out of the test driver's process, which runs as the same user.

Otherwise the node could open the pipe of results below `/proc/PID/fd`. A process in a Landlock domain cannot inspect
processes outside of it. Since Linux 6.12 it cannot send signals to them either.
"""

from __future__ import annotations

import ctypes
import os
import struct

# The same numbers on all architectures; constants are those of linux/landlock.h and linux/prctl.h.
_CREATE_RULESET = 444
_ADD_RULE = 445
_RESTRICT_SELF = 446
_GET_VERSION = 1
_RULE_PATH_BENEATH = 1
_ACCESS_MAKE_BLOCK = 1 << 11
_ACCESS_REFER = 1 << 13
_SCOPE_SIGNAL = 1 << 1
_SET_NO_NEW_PRIVILEGES = 38

_FIRST_WITH_REFER = 2
_FIRST_WITH_SCOPE = 6


def enter() -> str:
    """Put this process, which must have one thread, and its children into a new domain.

    Returns why that is impossible on this machine; empty if it was done.
    """
    libc = ctypes.CDLL(None, use_errno=True)
    version = libc.syscall(_CREATE_RULESET, None, ctypes.c_size_t(0), _GET_VERSION)
    if version < 1:
        return f"Landlock is not available ({os.strerror(ctypes.get_errno())}); it needs Linux 5.13 or newer"
    ruleset = -1
    try:
        ruleset = _checked(libc.syscall(_CREATE_RULESET, *_ruleset(version), 0))
        if version >= _FIRST_WITH_REFER:
            _allow_renaming(libc, ruleset)
        _checked(libc.prctl(_SET_NO_NEW_PRIVILEGES, 1, 0, 0, 0))
        _checked(libc.syscall(_RESTRICT_SELF, ruleset, 0))
    except OSError as e:
        return f"Landlock does not work: {e.strerror}"
    finally:
        if ruleset >= 0:
            os.close(ruleset)
    return ""


def _ruleset(version: int) -> tuple[bytes, ctypes.c_size_t]:
    """A ruleset must handle an access. This one takes none away that a node has.

    The first version denies moving files between folders in any case.
    """
    access = _ACCESS_REFER if version >= _FIRST_WITH_REFER else _ACCESS_MAKE_BLOCK
    attributes = struct.pack("=Q", access)
    if version >= _FIRST_WITH_SCOPE:
        attributes += struct.pack("=QQ", 0, _SCOPE_SIGNAL)
    return attributes, ctypes.c_size_t(len(attributes))


def _allow_renaming(libc: ctypes.CDLL, ruleset: int) -> None:
    root = os.open("/", os.O_PATH | os.O_CLOEXEC)
    try:
        _checked(libc.syscall(_ADD_RULE, ruleset, _RULE_PATH_BENEATH, struct.pack("=Qi", _ACCESS_REFER, root), 0))
    finally:
        os.close(root)


def _checked(result: int) -> int:
    if result < 0:
        raise OSError(ctypes.get_errno(), os.strerror(ctypes.get_errno()))
    return result
