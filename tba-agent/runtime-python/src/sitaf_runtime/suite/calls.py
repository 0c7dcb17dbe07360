"""Calls of the test stub."""

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class StubCall:
    """A call with the literals of its arguments by name; `method` is `Interface.Method`."""

    method: str
    arguments: dict[str, str]
