"""A required interface of the component."""

from typing import Protocol


class Wheels(Protocol):
    """The required interface Wheels, as hardware.idl describes it."""

    def Drive(self, linear: float, angular: float) -> None: ...
