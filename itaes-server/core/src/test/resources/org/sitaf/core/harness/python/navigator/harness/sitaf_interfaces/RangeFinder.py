"""A required interface of the component."""

from typing import Protocol


class RangeFinder(Protocol):
    """The required interface RangeFinder, described in hardware.idl."""

    def RangeAhead(self, bearing: float) -> float: ...

    def Beams(self, first: int) -> tuple[bool, float, float]: ...
