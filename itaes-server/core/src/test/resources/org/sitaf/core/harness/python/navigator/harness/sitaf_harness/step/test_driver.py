"""Test driver (TD) of Navigator.Step.

Runs the cases of the test model Step.

One step, with 'quotes' and a \\ backslash
"""

from abc import abstractmethod

from navigation.navigator import Navigator
from sitaf_harness.step.simulation_control import SimulationControl
from sitaf_harness.step.test_stub import TestStub
from sitaf_interfaces import Point, Route
from sitaf_runtime.component import part_of
from sitaf_runtime.driver import SuiteDriver
from sitaf_runtime.out import InOut, Out
from sitaf_runtime.run import TestRun
from sitaf_runtime.suite.kinds import FLOAT32, FLOAT64, INT32, sequence, struct
from sitaf_runtime.suite.result import CaseResult
from sitaf_runtime.suite.test_case import TestCase


class TestDriver(SuiteDriver[Navigator]):
    """Runs the test cases one by one."""

    SUITE_LIFE = True

    def __init__(self, run: TestRun) -> None:
        super().__init__(run)
        self.simulation_control = SimulationControl()
        self.test_stub = TestStub(run)

    @abstractmethod
    def call(
        self,
        component: Navigator,
        route: Route,
        gain: float,
        weights: list[int],
        target: Out[Point],
        heading: InOut[float],
    ) -> int:
        """Call the method under test, Navigator.Step.

        Only this call is timed.
        """

    def new_component(self) -> Navigator:
        """Create the component with the arguments that its constructor requires."""
        return self.make(Navigator, self.test_stub.range_finder, self.test_stub.wheels)

    def run_case(self, test_case: TestCase, result: CaseResult) -> None:
        """Run one case in the five steps of Fig. 10."""
        # 1. Read the test case.
        route = test_case.assemble(
            struct(Route),
            {"route.points[1].x": ("points", 1, "x"), "route.name": ("name",)},
        )
        gain = test_case.read("gain", FLOAT32)
        weights = test_case.read("weights", sequence(INT32))
        target: Out[Point] = Out()
        heading = InOut(test_case.read("heading", FLOAT64))
        range_finder_range_ahead = test_case.read("RangeFinder.RangeAhead", FLOAT64)
        range_finder_range_ahead_2 = test_case.read("RangeFinder.RangeAhead#2", FLOAT64)
        range_finder_beams_left = test_case.read("RangeFinder.Beams.left", FLOAT64)

        # 2. The simulation control sets up the virtual environment (TDSD).
        self.simulation_control.prepare()

        # 3. The test stub gets the answers of the required interfaces (TDTS).
        self.test_stub.prepare(
            range_finder_range_ahead,
            range_finder_range_ahead_2,
            range_finder_beams_left,
        )

        # 4. The component is called with the input (TDI). The call is timed.
        component = self.component()
        self.before_case(component, test_case)
        self.stopwatch.start()
        returned = self.call(component, route, gain, weights, target, heading)
        self.stopwatch.stop()
        self.after_case(component, test_case)

        # 5. The outputs are recorded and saved.
        result.record("return", returned, INT32)
        result.record("target", target.value, struct(Point))
        result.record("heading", heading.value, FLOAT64)
        result.record("target.x", part_of(target.value, "x"), FLOAT64)
        self.save(result)
