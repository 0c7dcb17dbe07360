"""Test stub (TS): implements the interfaces that the component requires."""

from sitaf_interfaces import RangeFinder, Wheels
from sitaf_runtime.run import TestRun
from sitaf_runtime.stub import StubbedMethod
from sitaf_runtime.suite.kinds import BOOLEAN, FLOAT64, INT32


class RangeFinderStub(RangeFinder):
    """Stub of RangeFinder."""

    def __init__(self, run: TestRun) -> None:
        self.on_range_ahead = StubbedMethod(
            run.stubbing, "RangeFinder.RangeAhead", FLOAT64, inputs={"bearing": FLOAT64}
        )
        self.on_beams = StubbedMethod(
            run.stubbing,
            "RangeFinder.Beams",
            BOOLEAN,
            inputs={"first": INT32},
            outs={"left": FLOAT64, "right": FLOAT64},
        )

    def RangeAhead(self, bearing: float) -> float:
        return self.on_range_ahead.call(bearing)

    range_ahead = RangeAhead

    def Beams(self, first: int) -> tuple[bool, float, float]:
        return self.on_beams.call(first)

    beams = Beams


class WheelsStub(Wheels):
    """Stub of Wheels."""

    def __init__(self, run: TestRun) -> None:
        self.on_drive = StubbedMethod(
            run.stubbing,
            "Wheels.Drive",
            None,
            inputs={"linear": FLOAT64, "angular": FLOAT64},
        )

    def Drive(self, linear: float, angular: float) -> None:
        return self.on_drive.call(linear, angular)

    drive = Drive


class TestStub:
    """Sets the answers of a case."""

    def __init__(self, run: TestRun) -> None:
        self.range_finder = RangeFinderStub(run)
        self.wheels = WheelsStub(run)

    def prepare(
        self,
        range_finder_range_ahead: float,
        range_finder_range_ahead_2: float,
        range_finder_beams_left: float,
    ) -> None:
        """Set the answers of a case."""
        self.range_finder.on_range_ahead.reset()
        self.range_finder.on_range_ahead.answer(range_finder_range_ahead)
        self.range_finder.on_range_ahead.answer(range_finder_range_ahead_2, from_call=2)
        self.range_finder.on_beams.reset()
        self.range_finder.on_beams.answer(range_finder_beams_left, out="left")
        self.wheels.on_drive.reset()
