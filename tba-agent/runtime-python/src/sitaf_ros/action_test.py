"""The test application's side of actions: a client for servers of nodes, and a server for clients of nodes.

Actions are services and topics below `NAME/_action`, as https://design.ros2.org/articles/actions.html defines.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from sitaf_ros import conversion
from sitaf_ros.messages import Message

if TYPE_CHECKING:
    from sitaf_ros.test_side import ServiceCall, TestSide

STATUS = {"unknown": 0, "accepted": 1, "executing": 2, "canceling": 3, "succeeded": 4, "canceled": 5, "aborted": 6}
CANCELED = 5


@dataclass(frozen=True)
class ActionAnswer:
    """What the test application's action server does with a goal; times are seconds after its acceptance."""

    accept: bool = True
    feedback: tuple[tuple[float, Any], ...] | list[tuple[float, Any]] = ()
    after_s: float = 0.0
    status: str = "succeeded"
    result: Any = field(default_factory=dict)
    accept_cancel: bool = True


class GoalUnderTest:
    """A goal that the test application sent."""

    def __init__(
        self,
        system: TestSide,
        name: str,
        type_name: str,
        fields: Mapping[str, Any] | Message,
        feedback: Callable[[Any, int], None] | None,
    ) -> None:
        self._system, self._name, self._type = system, name, type_name
        self.accepted: bool | None = None
        self.done = False
        self.status = 0
        self.result: Any = None
        self.error: str | None = None
        action = system.application.classes.message(type_name)
        goal = conversion.from_fields(system.application.classes, action.Goal._definition.name, fields)
        self.uuid = system.next_number().to_bytes(16, "big")
        if feedback is not None:

            def take(message: Any, time_ns: int) -> None:
                if bytes(message.goal_id.uuid) == self.uuid:
                    feedback(message.feedback, time_ns)

            system.subscribe(f"{name}/_action/feedback", f"{type_name}_FeedbackMessage", take)
        request = {"goal_id": {"uuid": self.uuid}, "goal": goal}
        call = system.call_service(f"{name}/_action/send_goal", f"{type_name}_SendGoal", request, self._answered)
        if call.error is not None:
            self.error, self.done, self.accepted = f"no node offers the action {name} of type {type_name}", True, False

    def _answered(self, response: Any) -> None:
        self.accepted = bool(response.accepted)
        if not self.accepted:
            self.done = True
            return
        request = {"goal_id": {"uuid": self.uuid}}
        self._system.call_service(
            f"{self._name}/_action/get_result", f"{self._type}_GetResult", request, self._finished
        )

    def _finished(self, response: Any) -> None:
        self.done, self.status, self.result = True, int(response.status), response.result

    def cancel(self) -> ServiceCall:
        """Ask the server to cancel the goal."""
        request = {"goal_info": {"goal_id": {"uuid": self.uuid}}}
        return self._system.call_service(f"{self._name}/_action/cancel_goal", "action_msgs/srv/CancelGoal", request)


@dataclass
class _ServedGoal:
    answer: ActionAnswer
    status: int = STATUS["executing"]
    result: Any = None
    waiting: list[Callable[[Any], None]] = field(default_factory=list)


class _ActionServer:
    def __init__(self, system: TestSide, name: str, type_name: str, answer: Callable[[Any], ActionAnswer]) -> None:
        self._system, self._name, self._type, self._answer = system, name, type_name, answer
        self._goals: dict[bytes, _ServedGoal] = {}
        base = f"{name}/_action"
        system.advertise(f"{base}/feedback", f"{type_name}_FeedbackMessage")
        system.advertise(f"{base}/status", "action_msgs/msg/GoalStatusArray")
        system.serve_service(f"{base}/send_goal", f"{type_name}_SendGoal", self._goal)
        system.serve_service(f"{base}/cancel_goal", "action_msgs/srv/CancelGoal", self._cancel)
        self._serve_result(f"{base}/get_result")

    def _goal(self, request: Any) -> Any:
        answer = self._answer(request.goal)
        stamp = dict(zip(("sec", "nanosec"), divmod(self._system.ros_time_ns(), 10**9), strict=True))
        if answer.accept:
            uuid = bytes(request.goal_id.uuid)
            goal = self._goals[uuid] = _ServedGoal(answer)
            for seconds, fields in answer.feedback:
                self._system.later(seconds, lambda f=fields: self._feedback(uuid, goal, f))
            self._system.later(answer.after_s, lambda: self._finish(goal, STATUS[answer.status]))
        return {"accepted": answer.accept, "stamp": stamp}

    def _feedback(self, uuid: bytes, goal: _ServedGoal, fields: Any) -> None:
        if goal.result is None:
            feedback = conversion.from_fields(self._system.application.classes, f"{self._type}_Feedback", fields)
            message = {"goal_id": {"uuid": uuid}, "feedback": feedback}
            self._system.publish(f"{self._name}/_action/feedback", f"{self._type}_FeedbackMessage", message)

    def _finish(self, goal: _ServedGoal, status: int) -> None:
        if goal.result is None:
            fields = goal.answer.result if status != CANCELED else {}
            result = conversion.from_fields(self._system.application.classes, f"{self._type}_Result", fields or {})
            goal.status, goal.result = status, {"status": status, "result": result}
            for respond in goal.waiting:
                respond(goal.result)

    def _cancel(self, request: Any) -> Any:
        uuid = bytes(request.goal_info.goal_id.uuid)
        chosen = [u for u in self._goals if not any(uuid) or u == uuid]
        canceling = []
        for one in chosen:
            goal = self._goals[one]
            if goal.result is None and goal.answer.accept_cancel:
                canceling.append({"goal_id": {"uuid": one}})
                self._system.later(0, lambda g=goal: self._finish(g, CANCELED))
        # ERROR_REJECTED, ERROR_UNKNOWN_GOAL_ID
        code = 0 if canceling else 1 if chosen else 2
        return {"return_code": code, "goals_canceling": canceling}

    def _serve_result(self, name: str) -> None:
        type_name = f"{self._type}_GetResult"
        classes = self._system.application.classes
        response_name = classes.message(type_name).Response._definition.name

        def ask(_: int, request: Any, respond: Callable[[Message], None]) -> None:
            def answer(fields: Any) -> None:
                respond(conversion.from_fields(classes, response_name, fields))

            goal = self._goals.get(bytes(request.goal_id.uuid))
            if goal is None:
                answer({})
            elif goal.result is None:
                goal.waiting.append(answer)
            else:
                answer(goal.result)

        self._system.serve(name, type_name, ask)


def serve_action(system: TestSide, name: str, type_name: str, answer: Callable[[Any], ActionAnswer]) -> None:
    """Offer an action to the nodes."""
    _ActionServer(system, name, type_name, answer)
