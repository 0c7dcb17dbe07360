"""How messages name a callback: `Follower.on_scan`."""

from __future__ import annotations

import functools
from typing import Any


def callback_name(callback: Any) -> str:
    """Return a name that a user finds in the sources."""
    while isinstance(callback, functools.partial):
        callback = callback.func
    name = getattr(callback, "__qualname__", None) or type(callback).__qualname__
    code = getattr(callback, "__code__", None)
    line = f" (line {code.co_firstlineno})" if "<lambda>" in name and code is not None else ""
    return name.replace("<locals>.", "") + line
