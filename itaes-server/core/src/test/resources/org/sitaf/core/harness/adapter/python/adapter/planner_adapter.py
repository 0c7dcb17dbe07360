"""Binds the component to the interfaces of its test."""

from sitaf_interfaces import Mode, Path, Point, RangeFinder
from sitaf_runtime import Hardware


class PlannerAdapter:
    """The component, with the methods of the interfaces."""

    def __init__(self, hardware: Hardware, range_finder: RangeFinder) -> None:
        # Make the component here, and keep it in an attribute.
        # Through the hardware it reaches the simulated devices.
        self._hardware = hardware
        # The test stub answers for what it requires.
        self._range_finder = range_finder

    def Plan(
        self, goal: Point, weights: list[float], budget: int
    ) -> tuple[Path, bool, int]:
        # Pass the call on to the component, and return what it answers.
        raise NotImplementedError("Plan is not passed on yet")

    def SetMode(self, mode: Mode) -> None:
        # Pass the call on to the component.
        # It may raise, of sitaf_interfaces: Busy.
        raise NotImplementedError("SetMode is not passed on yet")

    def SetLimit(self, limit: int) -> None:
        # Pass the call on to the component.
        raise NotImplementedError("SetLimit is not passed on yet")
