"""Calls of a user's callback from within other work."""

from __future__ import annotations

import inspect
from typing import Any

from sitaf_ros.callback_names import callback_name, is_of_user
from sitaf_ros.current import system


def register(callback: Any) -> None:
    """Note a callback, so that a report can say that it was never called."""
    if callback is not None and is_of_user(callback):
        system().unobserved.callback(callback_name(callback))


def call(callback: Any, *args: Any) -> Any:
    """Call it; an exception is an error of the case with the callback's name."""
    name = callback_name(callback)
    system().unobserved.called(name)
    try:
        return callback(*args)
    except Exception as e:
        system().failed(f"callback {name}", e)
        raise


async def await_call(callback: Any, *args: Any) -> Any:
    """Call it, and await it if it is a coroutine."""
    result = call(callback, *args)
    if not inspect.iscoroutine(result):
        return result
    try:
        return await result
    except Exception as e:
        system().failed(f"callback {callback_name(callback)}", e)
        raise
