"""Test stub (TS): the component requires no interface."""

from sitaf_runtime.run import TestRun


class TestStub:
    """Has nothing to answer."""

    def __init__(self, run: TestRun) -> None:
        """Need nothing of the run."""

    def prepare(self) -> None:
        """Leave all as it is."""
