"""A required interface of the component."""

from typing import Protocol


class Wheels(Protocol):
    """The required interface Wheels, described in hardware.idl."""

    def Drive(self, linear: float, angular: float) -> None: ...
