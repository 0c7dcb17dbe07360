"""How messages name a callback: `Follower.on_scan`."""

from __future__ import annotations

import functools
from pathlib import Path
from typing import Any

_API = str(Path(__file__).parent / "api")


def is_of_user(callback: Any) -> bool:
    """Tell whether a callback is of the node's sources, not of the API that comes along."""
    while isinstance(callback, functools.partial):
        callback = callback.func
    code = getattr(callback, "__code__", None)
    return code is None or not code.co_filename.startswith(_API)


def callback_name(callback: Any) -> str:
    """Return a name that a user finds in the sources."""
    while isinstance(callback, functools.partial):
        callback = callback.func
    name = getattr(callback, "__qualname__", None) or type(callback).__qualname__
    code = getattr(callback, "__code__", None)
    line = f" (line {code.co_firstlineno})" if "<lambda>" in name and code is not None else ""
    return name.replace("<locals>.", "") + line
