"""Concrete test driver of InfraredSensorService.GetInfraredData.

What is particular about the test, to be changed freely. Keep a changed version in the
activity as harness/GetInfraredData/concrete_test_driver.py: it is used from then on,
and never generated over.
"""

from infrared_sensor import InfraredSensor
from sitaf_harness.get_infrared_data.test_driver import TestDriver
from sitaf_runtime.component import method_of, set_property
from sitaf_runtime.run import start
from sitaf_runtime.suite.test_case import TestCase


class ConcreteTestDriver(TestDriver):
    """Makes the component, sets it up and calls it."""

    def create_component(self) -> InfraredSensor:
        """Make the component and set it up."""
        component = self.new_component()
        set_property(component, "Size", "7")
        self.begin(component)
        method_of(component, "Enable")()
        return component

    def before_case(self, component: InfraredSensor, test_case: TestCase) -> None:
        """Run before each call, when the world and the stub are set."""

    def after_case(self, component: InfraredSensor, test_case: TestCase) -> None:
        """Run after each call, before its result is judged."""

    def call(
        self, component: InfraredSensor, index_of_sensor: int, num_of_sensor: int
    ) -> float:
        """The call under test; nothing else is timed."""
        return method_of(component, "GetInfraredData")(index_of_sensor, num_of_sensor)


if __name__ == "__main__":
    start(ConcreteTestDriver)
