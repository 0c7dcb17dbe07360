"""Concrete test driver of Navigator.Step.

You may edit this class. To keep your changes, save this file in the activity as
harness/Step/concrete_test_driver.py. It then replaces the generated file.
"""

from navigation.navigator import Navigator
from sitaf_harness.step.test_driver import TestDriver
from sitaf_interfaces import Mode, Point, Route
from sitaf_runtime.component import call_with_outs, method_of, set_property
from sitaf_runtime.out import InOut, Out
from sitaf_runtime.run import start
from sitaf_runtime.suite.test_case import TestCase


class ConcreteTestDriver(TestDriver):
    """Creates, sets up and calls the component."""

    def create_component(self) -> Navigator:
        """Create and set up the component."""
        component = self.new_component()
        set_property(component, "Label", 'a "quoted" one')
        set_property(component, "MaxSpeed", "0.5")
        self.begin(component)
        method_of(component, "Configure")(Mode.BUSY, 1.5, "left")
        return component

    def before_case(self, component: Navigator, test_case: TestCase) -> None:
        """Run before each call, after the world and the stub are prepared."""

    def after_case(self, component: Navigator, test_case: TestCase) -> None:
        """Run after each call, before its result is compared."""

    def call(
        self,
        component: Navigator,
        route: Route,
        gain: float,
        weights: list[int],
        target: Out[Point],
        heading: InOut[float],
    ) -> int:
        """Call the method under test. Only this call is timed."""
        return call_with_outs(
            method_of(component, "Step"),
            route,
            gain,
            weights,
            target,
            heading,
            returns=True,
        )


if __name__ == "__main__":
    start(ConcreteTestDriver)
