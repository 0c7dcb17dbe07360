"""Test stub (TS): not used, because the component requires no interface."""

from sitaf_runtime.run import TestRun


class TestStub:
    """Does nothing."""

    def __init__(self, run: TestRun) -> None:
        """Ignore the run."""

    def prepare(self) -> None:
        """Do nothing."""
