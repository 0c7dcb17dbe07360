"""The test driver of sequences of ROS 2 nodes."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from sitaf_runtime.ros.driver import RosTestDriver
from sitaf_runtime.sequence import SequenceDriver
from sitaf_runtime.suite.kinds import FLOAT64
from sitaf_runtime.suite.result import CaseResult, Outcome
from sitaf_runtime.suite.test_case import TestCase, TestStep

if TYPE_CHECKING:
    from sitaf_runtime.ros.plan import Call
    from sitaf_runtime.run import TestRun
    from sitaf_runtime.simulation.session import Simulation

# What the names of faults of devices begin with.
_FAULT = "fault."


class RosSequenceDriver(RosTestDriver, SequenceDriver[object]):
    """Lets the process of the node make the calls of a case; events change its world between them."""

    def __init__(self, run: TestRun) -> None:
        super().__init__(run)
        self._simulation: Simulation | None = None
        # Simulation time of the node, in nanoseconds.
        self._now_ns = 0
        self._first_ns = 0
        # Whether the process of the node waits for a step.
        self._waits = False
        self._message: dict[str, Any] = {}
        # The faults of the coming call, which begin with it.
        self._faults: dict[str, float] = {}

    def run_case(self, test_case: TestCase, result: CaseResult) -> None:
        """Run one case step by step. A node that ends, or whose callback fails, ends its case at that step."""
        try:
            self.begin_sequence(test_case)
            if not self._waits:
                self._finish(result)
                return
            for step in test_case.steps:
                if not self._run.run_step(self, step) or not self._waits:
                    self.save_sequence(result)
                    return
            self.stopwatch.reset()
            self.end_sequence(test_case)
            self._finish(result)
        finally:
            self._node.abandon()

    def begin_sequence(self, test_case: TestCase) -> None:
        """Start the node, and let time pass up to the first step."""
        self._waits = False
        self._simulation = self.begin_node(test_case)
        self._message = self.next_message(self._simulation)
        if "ready" in self._message:
            self._waits = True
            self._first_ns = self._now_ns = self._message["now_ns"]

    def run_step(self, step: TestStep, result: CaseResult) -> None:
        """Let the node's process make a call, or set what an event sets."""
        result.began_at(self._now_ns - self._first_ns)
        event = self._plan.events.get(step.name)
        if event is not None:
            self._run.simulation.set(event.set, event.to)
            return
        call = self._plan.calls.get(step.name)
        if call is None:
            raise self.unknown(step)
        self._set_up(step, call)
        self._waits = False
        self._node.answer({"call": step.name, "values": dict(step.values)})
        try:
            message = self.next_message(self._simulation)
        finally:
            if self.stopwatch.is_running:
                self.stopwatch.stop()
        if "stepped" in message:
            self._waits = True
            self._now_ns = message["now_ns"]
            self.complete(result, message["stepped"], "", call.outputs)
            return
        record = message.get("record")
        ended = message if "ended" in message else self.next_message(self._simulation)
        self.complete(result, record, ended.get("ended", ""))

    def _set_up(self, step: TestStep, call: Call) -> None:
        """Change the world as the step says."""
        values = {name: step.read(name, FLOAT64) for name in call.settings}
        self._faults = {name: value for name, value in values.items() if name.startswith(_FAULT)}
        for name, value in values.items():
            if name not in self._faults:
                self._run.simulation.set(name, value)

    def _answer(self, message: dict[str, Any], simulation: Simulation | None) -> dict[str, Any]:
        if "called" in message:
            for name, value in self._faults.items():
                self._run.simulation.set(name, value)
            self._faults = {}
        return super()._answer(message, simulation)

    def end_sequence(self, test_case: TestCase) -> None:
        """Let the time after the last step pass."""
        self._waits = False
        self._node.answer({"end": True})
        self._message = self.next_message(self._simulation)

    def _finish(self, result: CaseResult) -> None:
        """Save the record of the case by what the node's process has sent last."""
        record = self._message.get("record")
        ended = self._message if "ended" in self._message else self.next_message(self._simulation)
        self.complete(result, record, ended.get("ended", ""))
        too_long = self._run.took_too_long
        if too_long:
            result.end_with(Outcome.ERROR, too_long)
        self.save_sequence(result)
