"""Concrete test driver of Navigator.Step.

What is particular about the test, to be changed freely. Keep a changed version in the
activity as harness/Step/concrete_test_driver.py: it is used from then on, and never
generated over.
"""

from navigation.navigator import Navigator
from sitaf_harness.step.test_driver import TestDriver
from sitaf_interfaces import Mode, Point, Route
from sitaf_runtime.component import call_with_outs, method_of, set_property
from sitaf_runtime.out import InOut, Out
from sitaf_runtime.run import start
from sitaf_runtime.suite.test_case import TestCase


class ConcreteTestDriver(TestDriver):
    """Makes the component, sets it up and calls it."""

    def create_component(self) -> Navigator:
        """Make the component and set it up."""
        component = self.new_component()
        set_property(component, "Label", 'a "quoted" one')
        set_property(component, "MaxSpeed", "0.5")
        self.begin(component)
        method_of(component, "Configure")(Mode.BUSY, 1.5, "left")
        return component

    def before_case(self, component: Navigator, test_case: TestCase) -> None:
        """Run before each call, when the world and the stub are set."""

    def after_case(self, component: Navigator, test_case: TestCase) -> None:
        """Run after each call, before its result is judged."""

    def call(
        self,
        component: Navigator,
        route: Route,
        gain: float,
        weights: list[int],
        target: Out[Point],
        heading: InOut[float],
    ) -> int:
        """The call under test; nothing else is timed."""
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
