"""The test driver of ROS 2 nodes."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar, NoReturn

from sitaf_runtime.driver import SuiteDriver
from sitaf_runtime.errors import CannotRunError
from sitaf_runtime.ros.lines import packed
from sitaf_runtime.ros.node_process import NodeProcess
from sitaf_runtime.ros.plan import Plan
from sitaf_runtime.suite.calls import StubCall
from sitaf_runtime.suite.kinds import FLOAT64
from sitaf_runtime.suite.result import CaseResult, Outcome
from sitaf_runtime.suite.test_case import TestCase

if TYPE_CHECKING:
    from sitaf_runtime.run import TestRun
    from sitaf_runtime.simulation.session import Simulation


class RosTestDriver(SuiteDriver[object]):
    """Runs each case in the process of the node, and lets simulation time pass for it."""

    PLAN: ClassVar[Path]
    _loaded: ClassVar[tuple[Plan, NodeProcess] | None] = None

    @classmethod
    def load(cls) -> None:
        """Load the node in a process of its own, before this process opens files. Raises CannotRunError."""
        plan = Plan.read(cls.PLAN)
        # sitaf_harness/MODEL/plan.json
        cls._loaded = (plan, NodeProcess(plan, cls.PLAN.parents[2]))

    def __init__(self, run: TestRun) -> None:
        super().__init__(run)
        if self._loaded is None:
            raise CannotRunError("load() was not called before the run")
        self._plan, self._node = self._loaded

    def create_component(self) -> NoReturn:
        """The node's own process creates it."""
        raise CannotRunError("a ROS 2 node is not created in the process of the test driver")

    def run_case(self, test_case: TestCase, result: CaseResult) -> None:
        """Run one case and save its result."""
        simulation = self.begin_node(test_case)
        record: dict[str, Any] | None = None
        try:
            message = self.next_message(simulation)
            while "ended" not in message:
                record = message["record"]
                message = self.next_message(simulation)
        finally:
            self._node.abandon()
            if self.stopwatch.is_running:
                self.stopwatch.stop()
        call = self._plan.call
        self.complete(result, record, message["ended"], () if call is None else call.outputs)
        self.save(result)

    def begin_node(self, test_case: TestCase) -> Simulation | None:
        """Prepare the world of a case, and begin the case in the process of the node."""
        simulation = self._run.simulation if self._plan.world else None
        world = None
        if simulation is not None:
            parameters = {name: test_case.read(name, FLOAT64) for name in self._plan.settings}
            simulation.prepare(parameters, call_after_s=self._plan.settle_ns / 1e9)
            world = {"timestep_ns": simulation.time.timestep_ns, "readings": self._begin_readings(simulation)}
        self._node.begin({"values": dict(test_case.values), "world": world})
        return simulation

    def next_message(self, simulation: Simulation | None) -> dict[str, Any]:
        """Answer what the node's process asks for until it has ended, or has a record or a place for a step."""
        while True:
            message = self._node.next()
            if simulation is not None and "unread" in message:
                self._command(message, simulation)
                simulation.pass_unread(message["unread"])
                continue
            if simulation is not None:
                with self.stopwatch.in_hardware():
                    simulation.catch_up()
            if any(name in message for name in ("ended", "record", "ready", "stepped")):
                return message
            self._node.answer(self._answer(message, simulation))

    def _answer(self, message: dict[str, Any], simulation: Simulation | None) -> dict[str, Any]:
        if "called" in message:
            self.stopwatch.start()
        elif "returned" in message:
            self.stopwatch.stop()
        elif simulation is not None and "step" in message:
            with self.stopwatch.in_hardware():
                self._command(message, simulation)
                simulation.time.pass_steps(message["step"])
                wanted = [device for device in self._devices() if device in message["read"]]
                return {"readings": {device: packed(self._numbers(simulation, device)) for device in wanted}}
        elif simulation is not None and "look" in message:
            with self.stopwatch.in_hardware():
                image = simulation.hardware.camera(message["look"]).image()
            size = {"width": image.width, "height": image.height, "encoding": image.encoding}
            return {"image": {**size, "data": image.data.hex()}}
        return {}

    @staticmethod
    def _command(message: dict[str, Any], simulation: Simulation) -> None:
        for device, (linear, angular) in message["commands"].items():
            simulation.hardware.differential_drive(device).drive(linear, angular)

    def _devices(self) -> list[str]:
        """The devices whose numbers the node's process needs."""
        own = {topic.device: topic.kind for topic in self._plan.topics if topic.device and topic.kind != "camera"}
        if any(topic.world for topic in self._plan.topics):
            kinds = self._run.simulation.device_kinds
            own.update({name: kind for name, kind in kinds.items() if kind == "pose"})
        return sorted(own)

    def _begin_readings(self, simulation: Simulation) -> dict[str, dict[str, Any]]:
        readings: dict[str, dict[str, Any]] = {
            topic.device: {"kind": topic.kind, "numbers": []} for topic in self._plan.topics if topic.device
        }
        for device in self._devices():
            kind = simulation.device_kinds[device]
            readings[device] = {
                "kind": kind,
                "numbers": self._numbers(simulation, device),
                "setting": _setting(simulation, device, kind),
            }
        return readings

    @staticmethod
    def _numbers(simulation: Simulation, device: str) -> list[float]:
        return simulation.numbers(device)

    def complete(
        self, result: CaseResult, record: dict[str, Any] | None, ended: str, outputs: Sequence[dict[str, Any]] = ()
    ) -> None:
        """Complete the record of a case or a step by that of the node's process."""
        for note in (record or {}).get("notes", []):
            result.note(note)
        for method, arguments in (record or {}).get("calls", []):
            self._run.stubbing.calls.append(StubCall(method, arguments))
        if record is None or "error" in record or ended:
            reason = (record or {}).get("error") or ended or "the process of the node ended before the case"
            result.end_with(Outcome.ERROR, reason)
            return
        for name, literal in record["actual"].items():
            result.record_literal(name, literal)
        for output in outputs:
            if output["source"] == "observed":
                result.record(output["name"], self._run.simulation.observation(output["name"]), FLOAT64)
        if record["thrown"]:
            result.threw(type(record["thrown"], (Exception,), {})(), record["message"])

    def close(self) -> None:
        """Nothing to close: the node ends with its case."""


def _setting(simulation: Simulation, device: str, kind: str) -> dict[str, float]:
    """The constants of a device."""
    if kind == "laser_scan":
        scanner = simulation.hardware.laser_scanner(device)
        return {
            "angle_min": scanner.angle_min(),
            "angle_max": scanner.angle_max(),
            "angle_increment": scanner.angle_increment(),
            "range_min": scanner.min_range(),
            "range_max": scanner.max_range(),
        }
    if kind == "range":
        sensor = simulation.hardware.range_sensor(device)
        return {"min_range": sensor.min_range(), "max_range": sensor.max_range()}
    return {}
