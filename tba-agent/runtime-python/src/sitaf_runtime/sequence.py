"""Base class of the generated test drivers of sequences."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Set as AbstractSet
from typing import ClassVar, TypeVar

from sitaf_runtime.driver import SuiteDriver
from sitaf_runtime.errors import CaseDataError
from sitaf_runtime.overlapping import OverlappingSteps
from sitaf_runtime.suite.result import CaseResult, Outcome
from sitaf_runtime.suite.test_case import TestCase, TestStep

C = TypeVar("C")


class SequenceDriver(SuiteDriver[C]):
    """The test driver of a model with a sequence.

    A case is a list of steps, each of them a call of the component or an event of its world. The next step begins
    while one of `OVERLAPPING` runs; at most `AT_ONCE` of them run at once.
    """

    OVERLAPPING: ClassVar[AbstractSet[str]] = frozenset()
    AT_ONCE: ClassVar[int | None] = None

    # The case that is executed, whose initial values may be properties of the component.
    current_case: TestCase

    @abstractmethod
    def begin_sequence(self, test_case: TestCase) -> None:
        """Set up the world, the stubs and the component of a case."""

    @abstractmethod
    def run_step(self, step: TestStep, result: CaseResult) -> None:
        """Execute a step: make its call and record its outputs, or set what its event sets."""

    @abstractmethod
    def end_sequence(self, test_case: TestCase) -> None:
        """Let the time after the last step pass."""

    def run_case(self, test_case: TestCase, result: CaseResult) -> None:
        """Run one case step by step; the record of each step is written when it ends."""
        self.current_case = test_case
        self.begin_sequence(test_case)
        if any(step.name in self.OVERLAPPING for step in test_case.steps):
            complete = OverlappingSteps(self._run, self).run(test_case.steps)
        else:
            complete = all(self._run.run_step(self, step) for step in test_case.steps)
        if not complete:
            self.save_sequence(result)
            return
        self.stopwatch.reset()
        self.end_sequence(test_case)
        too_long = self._run.took_too_long
        if too_long:
            result.end_with(Outcome.ERROR, too_long)
        self.save_sequence(result)

    @staticmethod
    def unknown(step: TestStep) -> CaseDataError:
        """The exception for a step that this driver does not know."""
        return CaseDataError(f"the test driver has no step '{step.name}': generate the test application again")
