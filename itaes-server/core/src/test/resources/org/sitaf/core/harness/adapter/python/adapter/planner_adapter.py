"""Adapts the component to the interfaces of its test."""

from sitaf_interfaces import Mode, Path, Point, RangeFinder
from sitaf_runtime import Hardware


class PlannerAdapter:
    """Implements the methods of the interfaces."""

    def __init__(self, hardware: Hardware, range_finder: RangeFinder) -> None:
        # Create the component here and store it in an attribute.
        # The hardware gives access to the simulated devices.
        self._hardware = hardware
        # The required interfaces are implemented by the test stub.
        self._range_finder = range_finder

    def Plan(
        self, goal: Point, weights: list[float], budget: int
    ) -> tuple[Path, bool, int]:
        # Delegate the call to the component and return its result.
        raise NotImplementedError("Plan is not implemented yet")

    def SetMode(self, mode: Mode) -> None:
        # Delegate the call to the component.
        # May raise exceptions of sitaf_interfaces: Busy.
        raise NotImplementedError("SetMode is not implemented yet")

    def SetLimit(self, limit: int) -> None:
        # Delegate the call to the component.
        raise NotImplementedError("SetLimit is not implemented yet")
