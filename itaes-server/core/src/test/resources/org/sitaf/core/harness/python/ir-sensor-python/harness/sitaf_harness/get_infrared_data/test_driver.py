"""Test driver (TD) of InfraredSensorService.GetInfraredData.

Runs the cases of the test model GetInfraredData.

Distance to the obstacle, as infrared sensor IndexOfSensor sees it
"""

from abc import abstractmethod

from infrared_sensor import InfraredSensor
from sitaf_harness.get_infrared_data.simulation_control import SimulationControl
from sitaf_harness.get_infrared_data.test_stub import TestStub
from sitaf_runtime.driver import SuiteDriver
from sitaf_runtime.run import TestRun
from sitaf_runtime.suite.kinds import FLOAT64, INT32
from sitaf_runtime.suite.result import CaseResult
from sitaf_runtime.suite.test_case import TestCase


class TestDriver(SuiteDriver[InfraredSensor]):
    """Runs the test cases one by one."""

    SUITE_LIFE = False

    def __init__(self, run: TestRun) -> None:
        super().__init__(run)
        self.simulation_control = SimulationControl(run.simulation)
        self.test_stub = TestStub(run)

    @abstractmethod
    def call(
        self, component: InfraredSensor, index_of_sensor: int, num_of_sensor: int
    ) -> float:
        """Call the method under test, InfraredSensorService.GetInfraredData.

        Only this call is timed.
        """

    def new_component(self) -> InfraredSensor:
        """Create the component with the arguments that its constructor requires."""
        return self.make(InfraredSensor)

    def run_case(self, test_case: TestCase, result: CaseResult) -> None:
        """Run one case in the five steps of Fig. 10."""
        # 1. Read the test case.
        index_of_sensor = test_case.read("IndexOfSensor", INT32)
        num_of_sensor = test_case.read("NumOfSensor", INT32)
        distance = test_case.read("Distance", FLOAT64)

        # 2. The simulation control sets up the virtual environment (TDSD).
        self.simulation_control.prepare(distance)

        # 3. The test stub gets the answers of the required interfaces (TDTS).
        self.test_stub.prepare()

        # 4. The component is called with the input (TDI). The call is timed.
        component = self.component()
        self.before_case(component, test_case)
        self.stopwatch.start()
        returned = self.call(component, index_of_sensor, num_of_sensor)
        self.stopwatch.stop()
        self.after_case(component, test_case)

        # 5. The outputs are recorded and saved.
        result.record("return", returned, FLOAT64)
        self.save(result)
