"""Describes an exception of a component in one message."""

import os
import sys
import sysconfig
import traceback

_FRAMES = 4
_CAUSES = 3
_MAX_MESSAGE = 4000
# Maximum number of frames to search; an infinite recursion has thousands.
_DEEPEST = 200
_NOT_THE_USERS = tuple(
    os.path.join(folder, "")
    for folder in {
        os.path.dirname(os.path.abspath(__file__)),
        sysconfig.get_paths()["stdlib"],
        sysconfig.get_paths()["platstdlib"],
    }
)
_OURS = ("sitaf_runtime", "sitaf_ros", "sitaf_harness", "grpc")
_PACKAGES = ("site-packages", "dist-packages")


def describe(raised: BaseException) -> str:
    """Class, message and innermost frames in the component, for the exception and its causes."""
    parts: list[str] = []
    current: BaseException | None = raised
    seen: set[int] = set()
    while current is not None and len(parts) <= _CAUSES and id(current) not in seen:
        seen.add(id(current))
        parts.append(_describe_one(current))
        hidden = None if current.__suppress_context__ else current.__context__
        current = current.__cause__ or hidden
    return "; caused by ".join(parts)


def _describe_one(raised: BaseException) -> str:
    kind = type(raised)
    name = (
        kind.__qualname__ if kind.__module__ in ("builtins", "__main__") else f"{kind.__module__}.{kind.__qualname__}"
    )
    message = _message_of(raised)
    frames = [
        f"{frame.name} ({_short(frame.filename)}:{frame.lineno})"
        for frame in reversed(traceback.extract_tb(raised.__traceback__, limit=-_DEEPEST))
        if is_the_users(frame.filename)
    ]
    where = ", ".join(frames[:_FRAMES])
    return name + (f": {message}" if message else "") + (f" at {where}" if where else "")


def is_the_users(filename: str) -> bool:
    """Whether a file belongs to the component or a package that it uses, not to Python or SITAF."""
    parts = filename.split(os.sep)
    if filename.startswith("<frozen") or any(folder in _OURS for folder in parts[:-1]):
        return False
    return any(folder in _PACKAGES for folder in parts) or not filename.startswith(_NOT_THE_USERS)


def _short(filename: str) -> str:
    """A path relative to the folder that it was imported from."""
    for folder in sorted(map(os.path.abspath, filter(None, sys.path)), key=len, reverse=True):
        if filename.startswith(os.path.join(folder, "")):
            return os.path.relpath(filename, folder)
    return os.path.basename(filename)


def _message_of(raised: BaseException) -> str:
    """The message; `__str__` is code of the component and may raise."""
    try:
        return str(raised)[:_MAX_MESSAGE]
    except Exception as e:
        return f"(its message cannot be read: {type(e).__name__})"
