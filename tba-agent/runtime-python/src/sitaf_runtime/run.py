"""Runs a suite in this process.

Reads the cases, passes each to the test driver, and writes a record of every case, even when the component fails.
"""

from __future__ import annotations

import faulthandler
import gc
import os
import re
import signal
import sys
import time
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from itertools import islice
from typing import TYPE_CHECKING, Any, NoReturn

from sitaf_runtime import case_streams, debugging
from sitaf_runtime.command_line import CommandLine, Repetition
from sitaf_runtime.driver import SuiteDriver
from sitaf_runtime.errors import CannotRunError, CaseDataError, SimulationError
from sitaf_runtime.ports import WatchedPorts
from sitaf_runtime.robot.hardware import set_current
from sitaf_runtime.stopwatch import Stopwatch
from sitaf_runtime.stub import Stubbing
from sitaf_runtime.suite.reader import SuiteReader
from sitaf_runtime.suite.result import CaseResult, Outcome, ResultsFile
from sitaf_runtime.suite.test_case import TestCase, TestStep
from sitaf_runtime.thrown import describe

if TYPE_CHECKING:
    from sitaf_runtime.sequence import SequenceDriver
    from sitaf_runtime.simulation.session import Simulation

EXIT_DONE = 0
EXIT_CANNOT_RUN = 3
# A killed process loses the coverage since it was last saved.
_COVERAGE_EVERY_S = 1.0


class TestRun:
    """The state of a run, which its driver uses."""

    __test__ = False  # not a test of pytest

    def __init__(self, command: CommandLine, suite: SuiteReader, results: ResultsFile) -> None:
        self.stopwatch = Stopwatch()
        self.results = results
        self._cases = iter(suite)
        self._read: deque[TestCase] = deque()
        self._error: CaseDataError | None = None
        self._simulation: Simulation | None = None
        self._case_no = 0
        self._repetition = command.repetition
        # Whether a step of the current case has begun.
        self._in_sequence = False
        # Whether the current call is repeated, so that only its time and its outputs count.
        self._repeating = False
        if command.bridge is not None and command.world is not None:
            from sitaf_runtime.simulation.session import Simulation

            self._simulation = Simulation(
                command.bridge, command.world, command.seed, self.stopwatch, self._upcoming, command.case_sim_s
            )
            self.stopwatch.before_call(self._simulation.call_begins)
            if command.recording is not None:
                self._simulation.record(command.recording)
        self.ports = WatchedPorts()
        if self._simulation is not None:
            self._simulation.before_time_passes(self.ports.take)
        debugging.stop_in_calls(self.stopwatch)
        self.stubbing = Stubbing(self.stopwatch, self._simulation)

    @property
    def simulation(self) -> Simulation:
        """The simulator's session. Raises CannotRunError when there is none."""
        if self._simulation is None:
            raise CannotRunError("this test needs a simulation: start it with --bridge TARGET --world FILE.world.yaml")
        return self._simulation

    @property
    def simulation_if_any(self) -> Simulation | None:
        """The simulator's session; None when there is none."""
        return self._simulation

    @property
    def took_too_long(self) -> str | None:
        """The message when the case exceeded its limit of simulation time; otherwise None."""
        return None if self._simulation is None else self._simulation.took_too_long

    def save(self, result: CaseResult) -> None:
        """Write the record of a case with the calls of its stubs.

        Raises SimulationError when the simulator was lost, because later measurements are invalid.
        """
        ports = [] if self._simulation is None else self.ports.end(self._simulation.call_ns)
        self._keep_signals()
        self._require_simulator()
        if self._repeating:
            return
        result.set_calls(self.stubbing.calls, self.stubbing.left_out)
        result.set_ports(ports)
        if self._repetition is None:
            self.results.save(result)

    def watch(self, signal: str, read: Callable[[], str]) -> None:
        """Record the value of an output data port, which `read` returns, until the end of the case."""
        if self._simulation is not None:
            self.ports.watch(signal, read, self._simulation.now_ns)

    def read_ports(self) -> None:
        """Record the values of the output data ports now. Raises what a port raised in this case."""
        if self._simulation is not None:
            self.ports.take(self._simulation.now_ns)
            self.ports.require_read()

    def _keep_signals(self) -> None:
        """Let the simulator keep the signals of the current case, if it was called."""
        called = self.stopwatch.was_started or self._in_sequence
        if self._simulation is not None and called and not self._repeating:
            self._simulation.keep_signals(self._case_no)

    def _require_simulator(self) -> None:
        if self._simulation is not None:
            self._simulation.require_not_lost()

    def hardware(self) -> list[object]:
        """The hardware for the component; empty when there is no simulation."""
        return [] if self._simulation is None else [self._simulation.hardware]

    def run_all(self, first: int, factory: Callable[[TestRun], SuiteDriver[Any]]) -> None:
        """Run the cases, starting with the case number `first`; 0 for all."""
        set_current(None if self._simulation is None else self._simulation.hardware)
        try:
            driver = factory(self)
            self._skip_to(first)
            # Excludes the objects so far from garbage collection; cases are freed by reference counting.
            gc.collect()
            gc.freeze()
            self.results.ready()
            covered = time.monotonic()
            for case in self._each():
                self._run_one(driver, case)
                if time.monotonic() - covered > _COVERAGE_EVERY_S:
                    save_coverage()
                    covered = time.monotonic()
            case_streams.begin(0)
            _closing("closing the component", driver.close)
        finally:
            set_current(None)
            if self._simulation is not None:
                self._simulation.close()

    def _each(self) -> Iterator[TestCase]:
        while True:
            if self._read:
                yield self._read.popleft()
                continue
            if self._error:
                raise self._error
            case = next(self._cases, None)
            if case is None:
                return
            yield case

    def _upcoming(self, count: int) -> Sequence[TestCase]:
        """Up to `count` cases after the current one."""
        try:
            self._read.extend(islice(self._cases, max(0, count - len(self._read))))
        except CaseDataError as e:
            # Raised when the run reaches this case.
            self._error = e
        return list(islice(self._read, count))

    def _skip_to(self, first: int) -> None:
        for case in self._cases if first else ():
            if case.no == first:
                self._read.append(case)
                return
        if first:
            raise CannotRunError(f"--from {first}: the suite has no case of that number")

    def _run_one(self, driver: SuiteDriver[Any], case: TestCase) -> None:
        result = CaseResult(case)
        case_streams.begin(case.no)
        self._case_no = case.no
        if self._simulation is not None:
            self._simulation.case_begins(case.no)
        if self._repetition is None:
            self._call(driver, case, result)
            return
        began = time.monotonic()
        self._call(driver, case, result)
        if result.is_repeatable:
            self._repeating = True
            try:
                self._repeat(driver, case, result, self._repetition, began)
            finally:
                self._repeating = False
        self.results.save(result)

    def _repeat(
        self, driver: SuiteDriver[Any], case: TestCase, first: CaseResult, repetition: Repetition, began: float
    ) -> None:
        """Repeat the call of a case, each time in the same world and with a new component."""
        first.begin_repeated()
        for number in range(repetition.warm_up + repetition.repeat):
            if time.monotonic() - began > repetition.within_s:
                break
            again = CaseResult(case)
            self._call(driver, case, again)
            first.add_repeated(again, number + 2, measured=number >= repetition.warm_up)

    def _call(self, driver: SuiteDriver[Any], case: TestCase, result: CaseResult) -> None:
        self.stopwatch.reset()
        self._in_sequence = False
        driver.begin_case()
        try:
            try:
                driver.run_case(case, result)
            finally:
                driver.give_up()
            if not driver.is_saved:
                raise CannotRunError(f"the test driver ended case {case.no} without save(result)")
        except BaseException as raised:
            if driver.is_saved:
                _report(f"after case {case.no}: {describe(raised)}")
            else:
                self._end(result, raised)
        finally:
            if self._simulation is not None and not self._repeating:
                simulation = self._simulation
                _closing(f"recording case {case.no}", lambda: simulation.save_motion(case.no))
            _closing(f"closing the component after case {case.no}", driver.end_case)

    def run_step(self, driver: SequenceDriver[Any], step: TestStep) -> bool:
        """Execute a step of a sequence and write its record. An exception ends the step, not the sequence.

        Returns whether the next step can be executed: not when the case took too much simulation time. Raises when no
        further case can run.
        """
        result = CaseResult(step)
        self.step_begins(result)
        self.execute_step(driver, step, result)
        result.set_calls(*self.stubbing.take())
        self.results.save(result)
        return not self.took_too_long

    def step_begins(self, result: CaseResult) -> None:
        """Note in the record of a step when it begins."""
        if self._simulation is not None:
            if not self._in_sequence:
                self._simulation.call_begins()
            result.began_at(self._simulation.since_call_ns)
        self._in_sequence = True

    def execute_step(self, driver: SequenceDriver[Any], step: TestStep, result: CaseResult) -> None:
        """Execute a step in the calling thread, with the stopwatch of this thread.

        Raises when no further case can run.
        """
        watch = self.stopwatch.of_this_thread
        watch.reset()
        try:
            driver.run_step(step, result)
            if watch.was_started:
                result.set_time(watch.component_us, watch.hardware_us, watch.stub_us)
            if self.took_too_long:
                result.end_with(Outcome.ERROR, self.took_too_long)
        except BaseException as raised:
            self._fail(result, raised)
        finally:
            driver.give_up()
        self._require_simulator()

    def _end(self, result: CaseResult, raised: BaseException) -> None:
        """Save the record of a case that did not save its result. Raises when no further case can run."""
        self._fail(result, raised)
        self.save(result)

    def _fail(self, result: CaseResult, raised: BaseException) -> None:
        """Complete the record of a case or step that did not end as planned."""
        watch = self.stopwatch.of_this_thread
        called = watch.was_started
        self._require_simulator()
        if isinstance(raised, SimulationError) and raised.lost:
            raise raised
        if self.took_too_long:
            result.end_with(Outcome.ERROR, self.took_too_long)
        elif watch.is_running:
            watch.stop()
            result.set_time(watch.component_us, watch.hardware_us, watch.stub_us)
            result.threw(raised, describe(raised))
        elif isinstance(raised, CannotRunError):
            raise raised
        elif isinstance(raised, SimulationError):
            result.end_with(Outcome.ERROR if called else Outcome.NOT_CALLED, str(raised))
        elif isinstance(raised, CaseDataError) and not called:
            result.end_with(Outcome.NOT_CALLED, str(raised))
        else:
            result.end_with(Outcome.ERROR, describe(raised))


def execute(arguments: list[str], factory: Callable[[TestRun], SuiteDriver[Any]]) -> int:
    """Run a suite and return the exit code."""
    try:
        command = CommandLine.parse(arguments)
        suite = SuiteReader(command.suite)
        try:
            results = ResultsFile(command.results, append=command.first > 0)
            try:
                TestRun(command, suite, results).run_all(command.first, factory)
            finally:
                results.close()
        finally:
            suite.close()
        return EXIT_DONE
    except (CannotRunError, SimulationError, CaseDataError) as e:
        return cannot_run(str(e))
    except OSError as e:
        return cannot_run(f"{type(e).__name__}: {e}")


def start(factory: Callable[[TestRun], SuiteDriver[Any]], arguments: list[str] | None = None) -> NoReturn:
    """Run the suite that the arguments name, then end the process; the entry point of test applications.

    The exit code is 0 when every case has a result, and 3, with one line on the error stream, when the suite could not
    be run. Threads that the component left running are not waited for.
    """
    case_streams.install()
    faulthandler.enable()
    if hasattr(faulthandler, "register"):
        faulthandler.register(signal.SIGQUIT, all_threads=True)
        # A JVM blocks this signal in its threads, and child processes inherit that.
        signal.pthread_sigmask(signal.SIG_UNBLOCK, {signal.SIGQUIT})
    end(execute(sys.argv[1:] if arguments is None else arguments, factory))


def end(code: int) -> NoReturn:
    """Flush the output and end the process immediately."""
    save_coverage()
    for stream in (sys.stdout, sys.stderr):
        try:
            stream.flush()
        except (OSError, ValueError):
            continue  # Its reader has ended.
    os._exit(code)


def cannot_run(reason: str) -> int:
    """Print why the suite cannot be run."""
    _report(re.sub(r"\s*\n\s*", "; ", reason.strip()))
    return EXIT_CANNOT_RUN


def save_coverage() -> None:
    """Save the coverage so far if coverage.py runs in this process."""
    coverage = sys.modules.get("coverage")
    if coverage is not None:
        current = coverage.Coverage.current()
        if current is not None:
            current.save()


def _report(text: str) -> None:
    # The component may have closed the stream.
    with suppress(OSError, ValueError, AttributeError):
        print(f"sitaf: {text}", file=sys.stderr, flush=True)


def _closing(what: str, close: Callable[[], None]) -> None:
    """Run a clean-up step after a case. A failure is printed and does not change the result."""
    try:
        close()
    except BaseException as e:
        _report(f"{what}: {describe(e)}")
