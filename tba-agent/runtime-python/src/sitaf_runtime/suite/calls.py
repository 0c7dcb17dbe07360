"""Calls that the test stub got."""

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class StubCall:
    """A call, with its arguments by name as documents spell them; `method` is `Interface.Method`."""

    method: str
    arguments: dict[str, str]
