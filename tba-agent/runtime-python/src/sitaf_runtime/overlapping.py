"""Executes steps of a sequence that overlap.

An overlapping step has a thread of its own; the next step begins when its call waits for simulation time or has ended,
or at once without a simulation. Records are written in the order of the steps.
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from sitaf_runtime.errors import SimulationError
from sitaf_runtime.stopwatch import Stopwatch
from sitaf_runtime.suite.result import CaseResult
from sitaf_runtime.suite.test_case import TestStep
from sitaf_runtime.thrown import describe

if TYPE_CHECKING:
    from sitaf_runtime.run import TestRun
    from sitaf_runtime.sequence import SequenceDriver


class _TooLongError(Exception):
    """The case took too much simulation time."""


class _Begun:
    """A step that has begun."""

    def __init__(self, step: TestStep) -> None:
        self.step = step
        self.result = CaseResult(step)
        self.ended = False


class OverlappingSteps:
    """Executes the steps of a case of which some overlap, and writes their records."""

    def __init__(self, run: TestRun, driver: SequenceDriver[Any]) -> None:
        self._run = run
        self._driver = driver
        simulation = run.simulation_if_any
        self._time = None if simulation is None else simulation.time
        self._begun: list[_Begun] = []
        self._overlapping: list[_Overlapping] = []
        self._written = 0

    def run(self, steps: Sequence[TestStep]) -> bool:
        """Execute the steps.

        Returns whether all were executed: not when the case took too much simulation time. Raises when no further
        case can run.
        """
        try:
            for step in steps:
                self._begin(step)
            for overlapping in self._overlapping:
                self._await_end(overlapping)
        except _TooLongError as e:
            self._stop_all(str(e))
        except BaseException:
            self._stop_all("the case has ended")
            raise
        self._take_calls()
        self._save()
        return not self._run.took_too_long

    def _begin(self, step: TestStep) -> None:
        overlaps = step.name in self._driver.OVERLAPPING
        at_once = self._driver.AT_ONCE
        if overlaps and at_once is not None and len(self._overlapping) >= at_once:
            self._await_end(self._overlapping[-at_once])
        self._take_calls()
        self._save()
        begun = _Begun(step)
        self._begun.append(begun)
        self._run.step_begins(begun.result)
        if overlaps:
            overlapping = _Overlapping(self._run, self._driver, begun)
            self._overlapping.append(overlapping)
            overlapping.start()
            time = self._time
            if time is not None:
                # What settles before the call passes before the next step begins.
                self._let_pass(overlapping, lambda: time.pass_until(overlapping.thread, lambda: overlapping.is_called))
        else:
            self._run.execute_step(self._driver, step, begun.result)
            begun.ended = True
        if self._run.took_too_long:
            raise _TooLongError(self._run.took_too_long)

    def _await_end(self, overlapping: _Overlapping) -> None:
        time = self._time
        if time is not None:
            self._let_pass(overlapping, lambda: time.pass_until_leaves(overlapping.thread))
        overlapping.thread.join()
        if overlapping.fatal is not None:
            raise overlapping.fatal

    def _let_pass(self, overlapping: _Overlapping, passing: Callable[[], None]) -> None:
        """Let time pass for a step; an exception of a periodic component meanwhile ends the step."""
        try:
            passing()
        except BaseException as e:
            if isinstance(e, SimulationError) and e.lost:
                raise
            if self._run.took_too_long:
                raise _TooLongError(self._run.took_too_long) from e
            overlapping.stop(describe(e))

    def _stop_all(self, reason: str) -> None:
        """End the steps that still run, one after the other."""
        for overlapping in self._overlapping:
            overlapping.stop(reason)

    def _take_calls(self) -> None:
        """The calls of stubs so far belong to the step that began last."""
        if self._begun:
            self._begun[-1].result.set_calls(*self._run.stubbing.take())

    def _save(self) -> None:
        """Write the records of steps that have ended, up to the first one that has not."""
        while self._written < len(self._begun) and self._begun[self._written].ended:
            self._run.results.save(self._begun[self._written].result)
            self._written += 1


class _Overlapping:
    """A step on its own thread."""

    def __init__(self, run: TestRun, driver: SequenceDriver[Any], begun: _Begun) -> None:
        self._run = run
        self._driver = driver
        self._begun = begun
        self._stopwatch = Stopwatch()
        self._stopped: str | None = None
        self.fatal: BaseException | None = None
        name = f"step {begun.step.number} ({begun.step.name})"
        self.thread = threading.Thread(target=self._execute, name=name, daemon=True)

    @property
    def is_called(self) -> bool:
        """Whether the call of the step has begun."""
        return self._stopwatch.was_started

    def start(self) -> None:
        """Begin the step; with a simulation, its time passes only while the step waits for it."""
        simulation = self._run.simulation_if_any
        if simulation is not None:
            simulation.time.follow(self.thread)
        self.thread.start()

    def stop(self, reason: str) -> None:
        """End the step if it still runs, as an error: its waits raise an exception."""
        if not self._begun.ended:
            self._stopped = reason
            simulation = self._run.simulation_if_any
            if simulation is not None:
                simulation.time.give_up(self.thread)
        self.thread.join()

    def _execute(self) -> None:
        try:
            with self._run.stopwatch.separate(self._stopwatch):
                self._run.execute_step(self._driver, self._begun.step, self._begun.result)
        except BaseException as e:
            self.fatal = e
        finally:
            if self._stopped is not None:
                self._begun.result.stopped(self._stopped)
            self._begun.ended = True
            simulation = self._run.simulation_if_any
            if simulation is not None:
                simulation.time.leave()
