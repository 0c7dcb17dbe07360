"""Runs one case of a node, in the process of the node."""

from __future__ import annotations

import copy
from typing import TYPE_CHECKING, Any

from sitaf_runtime.ros.device_messages import Odometry, command_of, fields_of, transforms_of
from sitaf_runtime.ros.fields import Fields
from sitaf_runtime.ros.schedule import Publishing, Schedule
from sitaf_runtime.ros.stub import Stub, free, results_of
from sitaf_runtime.ros.world import World
from sitaf_runtime.suite.kinds import INT64

if TYPE_CHECKING:
    from sitaf_runtime.ros.lines import Lines
    from sitaf_runtime.ros.plan import Call, Plan, Topic

# The contract's limit on the recorded messages of a case.
MOST_MESSAGES = 1_000
_NANOS = 1_000_000_000
_INTERFACE = "topics"
_ROS_PARAMETERS = "ros__parameters"


class CallFailedError(Exception):
    """The call under test did not end; the message says why."""


class CaseRun:
    """One case: its node, its time and its messages."""

    def __init__(self, plan: Plan, application: Any, lines: Lines, begun: dict[str, Any]) -> None:
        self._plan = plan
        self._application = application
        self._lines = lines
        self._values: dict[str, str] = begun["values"]
        self._world = World(lines, begun["world"]) if plan.world else None
        self._fields = Fields(application.classes.message)
        self._schedule = Schedule()
        # By the place of the input in the activity.
        self._inputs: dict[int, tuple[Topic, dict[str, Any]]] = {}
        self._odometry: dict[str, Odometry] = {}
        self._step = 0
        self._sent: dict[str, int] = {}
        self._called = False
        self._call_ns = 0
        self._last: dict[str, Any] = {}
        self._count: dict[str, int] = {topic.output: 0 for topic in plan.topics if topic.output}
        self._messages = 0
        # Messages and calls of required services in their order.
        self._calls: list[tuple[str, dict[str, str]]] = []
        self._stubs: list[Stub] = []
        self._system: Any = None

    def run(self) -> dict[str, Any]:
        """Run the case and return its record. Raises what the node's callbacks raise, and CallFailedError."""
        self._system = self._application.start(self._settings())
        self._connect()
        self._system.run_until(0)
        if self._plan.call is not None:
            return self._make(self._plan.call)
        self._advance(self._plan.settle_ns)
        self._run_steps()
        self._advance(self._system.now_ns + self._plan.run_for_ns)
        return {"actual": {}, "calls": self._taken_calls(), "thrown": "", "message": ""}

    def _run_steps(self) -> None:
        """Make the calls that the process of the test driver names, one after the other."""
        answer = self._lines.ask({"ready": True, "now_ns": self._system.now_ns})
        while "call" in answer:
            self._values = answer["values"]
            try:
                record = self._make(self._plan.calls[answer["call"]])
            except CallFailedError as e:
                # Ends the step, not the sequence.
                record = {"error": str(e), "calls": self._taken_calls()}
            answer = self._lines.ask({"stepped": record, "now_ns": self._system.now_ns})

    def _make(self, call: Call) -> dict[str, Any]:
        """Make a call and return its record."""
        self._advance(self._system.now_ns + call.settle_ns)
        if self._plan.call is None:
            # The answers of this step, from now on.
            for stub in self._stubs:
                stub.replace(call.answers, self._values)
        # Messages before the call do not count.
        self._calls[:] = [made for made in self._calls if not made[0].startswith(f"{_INTERFACE}.")]
        self._call_ns = self._system.now_ns
        self._called = True
        self._last = {}
        self._count = dict.fromkeys(self._count, 0)
        self._measure(True)
        outcome = self._publish(call) if call.target["kind"] == "publish" else self._service(call)
        self._measure(False)
        self._advance(self._system.now_ns + call.run_for_ns)
        return self._record(call, outcome)

    def _measure(self, begins: bool) -> None:
        if self._world is not None:
            self._world.measured = begins
        self._lines.ask({"called" if begins else "returned": True})

    def _taken_calls(self) -> list[tuple[str, dict[str, str]]]:
        """The messages and calls since they were last taken."""
        taken = list(self._calls)
        self._calls.clear()
        return taken

    def close(self) -> None:
        """End the node; what it does then is not recorded."""
        if self._system is not None:
            self._system.end()

    def report(self) -> list[str]:
        """What the node did that nothing looked at."""
        if self._system is None:
            return []
        report = self._system.report()
        described = (
            ("the node never declares the parameter", report.undeclared_parameters),
            ("nothing observes the topic", report.unobserved_topics),
            ("nothing was published for the node on the topic", report.unfed_topics),
            ("never called:", [_named(callback) for callback in report.uncalled_callbacks]),
            ("different types of messages:", report.different_types),
            ("incompatible quality of service:", report.incompatible_qos),
            ("", report.warnings),
        )
        return [f"{text} {name}".strip() for text, names in described for name in names]

    # The node and its connections.

    def _settings(self) -> Any:
        from sitaf_ros import RosSettings

        node = self._plan.node
        given = {entry["column"].removeprefix("parameter."): self._parameter(entry) for entry in self._plan.parameters}
        parameters: dict[str, Any] = {**node["parameters"], **given}
        if node["parameter_file"]:
            parameters = _overriding(node["parameter_file"], given)
        return RosSettings(
            parameters=parameters,
            remap=node["remap"],
            callback_order=INT64.parse(self._values.get("ros.callback_order", "0")),
            use_sim_time=_flag({**node["parameters"], **given}.get("use_sim_time")),
            stdin=[self._values.get(name, "") for name in node["stdin"]],
            environment=node["environment"],
        )

    def _parameter(self, entry: dict[str, str]) -> Any:
        return self._fields.parse(entry["type"], self._values[entry["column"]])

    def _connect(self) -> None:
        system = self._system
        for topic in self._plan.topics:
            if topic.input or topic.senses:
                system.advertise(topic.name, topic.type)
            if topic.output:
                system.subscribe(topic.name, topic.type, lambda m, t, topic=topic: self._receive(topic, m, t))
            if topic.commands:
                system.subscribe(topic.name, topic.type, lambda m, t, topic=topic: self._command(topic, m))
        for entry in self._plan.required:
            stub = Stub(entry, self._plan.answers, self._values, self._fields, self._calls)
            stub.serve(system)
            self._stubs.append(stub)

    def _command(self, topic: Topic, message: Any) -> None:
        if self._world is not None:
            self._world.commands[topic.device] = command_of(self._system.fields(message))

    def _receive(self, topic: Topic, message: Any, time_ns: int) -> None:
        if not self._called:
            return
        self._count[topic.output] += 1
        fields = self._system.fields(message)
        self._last[topic.output] = fields
        if self._messages < MOST_MESSAGES:
            self._messages += 1
            types = self._fields.members(topic.type)
            literals = {name: self._fields.literal(types[name], value) for name, value in fields.items()}
            literals["t"] = self._fields.literal("double", (time_ns - self._call_ns) / _NANOS)
            self._calls.append((f"{_INTERFACE}.{topic.output}", literals))

    # Time.

    def _advance(self, end_ns: int) -> None:
        if self._world is not None:
            # Rounded up to whole steps.
            end_ns = -(-end_ns // self._world.timestep_ns) * self._world.timestep_ns
        while self._system.now_ns < end_ns:
            self._pass(end_ns)

    def _pass(self, end_ns: int) -> None:
        """Let time pass up to the next thing that happens, at most to the end."""
        if self._world is not None:
            self._pass_steps(self._world, end_ns)
            return
        due = self._schedule.next_ns()
        to_ns = end_ns if due is None else min(due, end_ns)
        self._system.run_before(to_ns)
        self._publish_due(to_ns)
        self._system.run_until(to_ns)

    def _pass_steps(self, world: World, end_ns: int) -> None:
        step_ns = world.timestep_ns
        coming = [end_ns, self._schedule.next_ns(), self._system.next_event_ns()]
        steps = [-(-time // step_ns) for time in coming if time is not None]
        sensing = [(self._step_of(world, topic, self._sent.get(topic.name, 0) + 1), topic) for topic in self._sensing()]
        to = max(self._step + 1, min([*steps, *(step for step, _ in sensing)]))
        sensed = [topic for step, topic in sensing if step <= to]
        # A scan has hundreds of numbers: only what is published now crosses between the processes.
        world.step(to - self._step, {device for topic in sensed for device in self._read_for(world, topic)})
        self._step = to
        now_ns = to * step_ns
        self._system.run_before(now_ns)
        for topic in sensed:
            self._sent[topic.name] = self._sent.get(topic.name, 0) + 1
            self._sense(world, topic, now_ns)
        self._publish_due(now_ns)
        self._system.run_until(now_ns)

    def _sensing(self) -> list[Topic]:
        return [topic for topic in self._plan.topics if topic.senses]

    @staticmethod
    def _read_for(world: World, topic: Topic) -> list[str]:
        """The devices that a message of a topic is made of."""
        if topic.world:
            return [name for name, reading in world.readings.items() if reading["kind"] == "pose"]
        return [] if topic.kind == "camera" else [topic.device]

    def _step_of(self, world: World, topic: Topic, number: int) -> int:
        """The step of a message: ceil(number / (rate * timestep)), with a margin for rounding."""
        exact = number * _NANOS / (topic.rate_hz * world.timestep_ns)
        return max(1, -int(-(exact - 1e-9) // 1))

    def _sense(self, world: World, topic: Topic, now_ns: int) -> None:
        if topic.world:
            sec, nanosec = divmod(self._system.ros_time_ns(), _NANOS)
            transforms = transforms_of(world.readings, {"sec": sec, "nanosec": nanosec})
            self._system.publish(topic.name, topic.type, {"transforms": transforms})
            return
        if topic.kind == "camera":
            world.look(topic.device)
        odometry = self._odometry.setdefault(topic.name, Odometry())
        fields = fields_of(topic, world.readings[topic.device], odometry, now_ns)
        self._system.publish(topic.name, topic.type, fields)

    # The call.

    def _publish(self, call: Call) -> dict[str, Any]:
        for order, topic in enumerate(topic for topic in self._plan.topics if topic.input):
            name = topic.input
            if name not in call.target["inputs"]:
                continue
            # What an earlier step has left to publish of this input is replaced.
            self._schedule.cancel(order)
            self._inputs[order] = (topic, self._given(call, topic.type, name))
            self._schedule.add(order, Publishing.of(self._values, name).times_ns(self._call_ns))
        self._publish_due(self._call_ns)
        self._system.run_until(self._call_ns)
        return {}

    def _publish_due(self, time_ns: int) -> None:
        for order in self._schedule.due(time_ns):
            topic, fields = self._inputs[order]
            self._system.publish(topic.name, topic.type, copy.deepcopy(fields))

    def _given(self, call: Call, type_: str, root: str) -> dict[str, Any]:
        """The fields that the case names for a message."""
        fields: dict[str, Any] = {}
        for entry in call.inputs:
            if entry["root"] == root:
                try:
                    fields = self._fields.put(fields, type_, entry["path"], self._values[entry["column"]])
                except ValueError as e:
                    raise ValueError(f"{entry['column']}: {e}") from e
        return fields

    def _service(self, call: Call) -> dict[str, Any]:
        target = call.target
        type_, name = target["type"], target["name"]
        class_ = self._application.classes.message(type_)
        is_action = target["kind"] == "action"
        asked = class_.Goal if is_action else class_.Request
        answered = class_.Result if is_action else class_.Response
        request = {}
        for field, field_type in asked.get_fields_and_field_types().items():
            given = self._given_field(call, field, field_type)
            if given is not None:
                request[field] = given
        feedback: list[Any] = []
        if is_action:
            goal = self._system.send_goal(
                name, type_, request, feedback=lambda m, _t: feedback.append(self._system.fields(m))
            )
            self._await(lambda: goal.done or goal.accepted is False, lambda: goal.error, name)
            if goal.error:
                raise CallFailedError(goal.error)
            if goal.accepted is False:
                return {"thrown": "GoalRejected", "message": f"{name} rejects the goal"}
            result = goal.result
        else:
            request_sent = self._system.call_service(name, type_, request)
            self._await(lambda: request_sent.done, lambda: request_sent.error, name)
            result = request_sent.response
        values = self._system.fields(result)
        types = dict(answered.get_fields_and_field_types())
        taken = set(asked.get_fields_and_field_types())
        answers = {name or "return": (types[field], values[field]) for name, field in results_of(types, taken).items()}
        if is_action:
            answers[free("feedback", "action_", taken)] = ("", feedback)
        return {"answers": answers}

    def _given_field(self, call: Call, field: str, type_: str) -> Any:
        value: Any = None
        for entry in call.inputs:
            if entry["root"] == field:
                value = self._fields._put(value, type_, entry["path"], self._values[entry["column"]])
        return value

    def _await(self, is_done: Any, error: Any, name: str) -> None:
        """Let time pass until a call of the test has ended."""
        limit_ns = self._call_ns + self._plan.case_sim_ns
        self._system.run_until(self._system.now_ns)
        while not is_done():
            if error():
                raise CallFailedError(str(error()))
            nothing = self._system.next_event_ns() is None and self._schedule.next_ns() is None
            if self._world is None and nothing:
                raise CallFailedError(f"{name} did not answer, and nothing will happen any more")
            if self._system.now_ns >= limit_ns:
                raise CallFailedError(f"{name} did not answer within {self._plan.case_sim_ns / _NANOS:g} s")
            event = self._system.next_event_ns()
            self._pass(limit_ns if event is None else max(min(limit_ns, event), self._system.now_ns))

    # The record.

    def _record(self, call: Call, outcome: dict[str, Any]) -> dict[str, Any]:
        answers: dict[str, tuple[str, Any]] = outcome.get("answers", {})
        actual: dict[str, str] = {}
        types = {topic.output: topic.type for topic in self._plan.topics if topic.output}
        for output in call.outputs:
            name, root, path = output["name"], output["root"], output["path"]
            if output["source"] == "count" and root in types:
                actual[name] = str(self._count[root])
            elif output["source"] == "count" and root in answers:
                actual[name] = str(len(answers[root][1]))
            elif output["source"] == "return" and root not in answers:
                actual[name] = "null"
            elif output["source"] in ("return", "out") and root in answers:
                type_, value = answers[root]
                actual[name] = self._part(type_, value, path)
            elif output["source"] == "out":
                type_ = types[root]
                value = self._last.get(root)
                if value is None:
                    value = self._system.fields(self._system.default(type_))
                actual[name] = self._part(type_, value, path)
        return {
            "actual": actual,
            "calls": self._taken_calls(),
            "thrown": outcome.get("thrown", ""),
            "message": outcome.get("message", ""),
        }

    def _part(self, type_: str, value: Any, path: list[str | int]) -> str:
        for step in path:
            try:
                value = value[step]
            except (LookupError, TypeError):
                return "null"
        if not type_:
            from sitaf_runtime.suite import literals

            return literals.write(value)
        return self._fields.literal(self._fields.type_of(type_, path), value)


def _named(callback: str) -> str:
    """A callback of Python has a name; one of C++ is described."""
    return callback if callback.startswith("the callback ") else f"the callback {callback}"


def _overriding(content: dict[str, Any], given: dict[str, Any]) -> dict[str, Any]:
    """The content of a parameter file in which the values of the case win, for every node."""
    merged: dict[str, Any] = copy.deepcopy(content)
    pending = [merged]
    while pending:
        for name, entry in pending.pop().items():
            if name == _ROS_PARAMETERS:
                entry.update(given)
            elif isinstance(entry, dict):
                pending.append(entry)
    merged.setdefault("/**", {}).setdefault(_ROS_PARAMETERS, {}).update(given)
    return merged


def _flag(value: Any) -> bool:
    return value is True or value in ("true", "True")
