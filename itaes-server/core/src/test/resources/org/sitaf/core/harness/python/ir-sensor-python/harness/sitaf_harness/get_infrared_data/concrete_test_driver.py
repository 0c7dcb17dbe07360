"""Concrete test driver of InfraredSensorService.GetInfraredData.

You may edit this class. To keep your changes, save this file in the activity as
harness/GetInfraredData/concrete_test_driver.py. It then replaces the generated file.
"""

from infrared_sensor import InfraredSensor
from sitaf_harness.get_infrared_data.test_driver import TestDriver
from sitaf_runtime.component import method_of, set_property
from sitaf_runtime.run import start
from sitaf_runtime.suite.test_case import TestCase


class ConcreteTestDriver(TestDriver):
    """Creates, sets up and calls the component."""

    def create_component(self) -> InfraredSensor:
        """Create and set up the component."""
        component = self.new_component()
        set_property(component, "Size", "7")
        self.begin(component)
        method_of(component, "Enable")()
        return component

    def before_case(self, component: InfraredSensor, test_case: TestCase) -> None:
        """Run before each call, after the world and the stub are prepared."""

    def after_case(self, component: InfraredSensor, test_case: TestCase) -> None:
        """Run after each call, before its result is compared."""

    def call(
        self, component: InfraredSensor, index_of_sensor: int, num_of_sensor: int
    ) -> float:
        """Call the method under test. Only this call is timed."""
        return method_of(component, "GetInfraredData")(index_of_sensor, num_of_sensor)


if __name__ == "__main__":
    start(ConcreteTestDriver)
