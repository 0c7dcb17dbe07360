"""Action servers."""

from __future__ import annotations

from enum import Enum
from typing import Any

from sitaf_ros.current import message, system

from ..qos import QoSProfile, qos_profile_action_status_default, qos_profile_services_default
from ..service import Service
from ..task import Future
from ..type_support import check_for_type_support
from ..user_callback import await_call, call, register

UNKNOWN, ACCEPTED, EXECUTING, CANCELING, SUCCEEDED, CANCELED, ABORTED = range(7)
NONE, REJECTED, UNKNOWN_GOAL, TERMINATED = range(4)
ACTIVE = (ACCEPTED, EXECUTING, CANCELING)
NAMES = ("UNKNOWN", "ACCEPTED", "EXECUTING", "CANCELING", "SUCCEEDED", "CANCELED", "ABORTED")
# The state machine of https://design.ros2.org/articles/actions.html.
TRANSITIONS = {
    (ACCEPTED, "EXECUTE"): EXECUTING,
    (ACCEPTED, "CANCEL_GOAL"): CANCELING,
    (EXECUTING, "CANCEL_GOAL"): CANCELING,
    (EXECUTING, "SUCCEED"): SUCCEEDED,
    (EXECUTING, "ABORT"): ABORTED,
    (CANCELING, "SUCCEED"): SUCCEEDED,
    (CANCELING, "ABORT"): ABORTED,
    (CANCELING, "CANCELED"): CANCELED,
}


class GoalResponse(Enum):
    REJECT = 1
    ACCEPT = 2


class CancelResponse(Enum):
    REJECT = 1
    ACCEPT = 2


class GoalEvent(Enum):
    EXECUTE = 1
    CANCEL_GOAL = 2
    SUCCEED = 3
    ABORT = 4
    CANCELED = 5


class ServerGoalHandle:
    def __class_getitem__(cls, item: Any) -> Any:
        return cls

    def __init__(self, action_server: ActionServer, goal_info: Any, goal_request: Any) -> None:
        self._action_server, self._goal_info, self._goal_request = action_server, goal_info, goal_request
        self._status = ACCEPTED
        self._response: Any = None

    def __eq__(self, other: object) -> bool:
        return isinstance(other, ServerGoalHandle) and self.goal_id == other.goal_id

    def __hash__(self) -> int:
        return hash(bytes(self.goal_id.uuid))

    @property
    def request(self) -> Any:
        return self._goal_request

    @property
    def goal_id(self) -> Any:
        return self._goal_info.goal_id

    @property
    def is_active(self) -> bool:
        return self._status in ACTIVE

    @property
    def is_cancel_requested(self) -> bool:
        return self._status == CANCELING

    @property
    def status(self) -> int:
        return self._status

    def _update_state(self, event: str) -> None:
        new = TRANSITIONS.get((self._status, event))
        if new is None:
            raise RuntimeError(
                f"Failed to update goal state: goal_handle attempted invalid transition from state "
                f"{NAMES[self._status]} with event {event}"
            )
        self._status = new
        self._action_server.publish_status()

    def execute(self, execute_callback: Any = None) -> None:
        if not self.is_cancel_requested:
            self._update_state("EXECUTE")
        self._action_server.notify_execute(self, execute_callback)

    def publish_feedback(self, feedback: Any) -> None:
        kinds = self._action_server.action_type
        if not isinstance(feedback, kinds.Feedback):
            raise TypeError(f"expected {kinds.Feedback}, got {type(feedback)}")
        self._action_server.publish_feedback(kinds.Impl.FeedbackMessage(goal_id=self.goal_id, feedback=feedback))

    def succeed(self, response: Any = None) -> None:
        self._end("SUCCEED", response)

    def abort(self, response: Any = None) -> None:
        self._end("ABORT", response)

    def canceled(self, response: Any = None) -> None:
        self._end("CANCELED", response)

    def _end(self, event: str, response: Any) -> None:
        self._update_state(event)
        self._response = response

    def destroy(self) -> None:
        """Nothing needs to be freed."""


def default_handle_accepted_callback(goal_handle: ServerGoalHandle) -> None:
    goal_handle.execute()


def default_goal_callback(goal_request: Any) -> GoalResponse:
    return GoalResponse.ACCEPT


def default_cancel_callback(cancel_request: Any) -> CancelResponse:
    return CancelResponse.REJECT


class _ActionService(Service):
    """A service whose callback gets the function that responds."""

    def _answer(self, number: int, request: Any, respond: Any) -> Any:
        return self.callback(request, respond)


class ActionServer:
    def __class_getitem__(cls, item: Any) -> Any:
        return cls

    def __init__(
        self,
        node: Any,
        action_type: Any,
        action_name: str,
        execute_callback: Any,
        *,
        callback_group: Any = None,
        goal_callback: Any = default_goal_callback,
        handle_accepted_callback: Any = default_handle_accepted_callback,
        cancel_callback: Any = default_cancel_callback,
        goal_service_qos_profile: Any = qos_profile_services_default,
        result_service_qos_profile: Any = qos_profile_services_default,
        cancel_service_qos_profile: Any = qos_profile_services_default,
        feedback_pub_qos_profile: Any = None,
        status_pub_qos_profile: Any = qos_profile_action_status_default,
        result_timeout: int = 10,
    ) -> None:
        check_for_type_support(action_type)
        if not callable(execute_callback):
            raise TypeError("Failed to register goal execution callback: not callable")
        self._node, self.action_type, self._action_name = node, action_type, action_name
        self._group = callback_group or node.default_callback_group
        self._execute_callback, self._goal_callback = execute_callback, goal_callback
        self._handle_accepted_callback, self._cancel_callback = handle_accepted_callback, cancel_callback
        for callback in (execute_callback, goal_callback, handle_accepted_callback, cancel_callback):
            if getattr(callback, "__module__", "") != __name__:
                register(callback)
        self._goal_handles: dict[bytes, ServerGoalHandle] = {}
        self._results: dict[bytes, Future] = {}
        kinds, base = action_type.Impl, f"{action_name}/_action"
        self._feedback = node.create_publisher(
            kinds.FeedbackMessage, f"{base}/feedback", feedback_pub_qos_profile or QoSProfile(depth=10)
        )
        self._status = node.create_publisher(kinds.GoalStatusMessage, f"{base}/status", status_pub_qos_profile)
        self._services = [
            self._service(kinds.SendGoalService, f"{base}/send_goal", self._on_goal, goal_service_qos_profile),
            self._service(kinds.CancelGoalService, f"{base}/cancel_goal", self._on_cancel, cancel_service_qos_profile),
            self._service(kinds.GetResultService, f"{base}/get_result", self._on_result, result_service_qos_profile),
        ]

    def _service(self, kind: Any, name: str, callback: Any, qos: Any) -> Service:
        full = self._node.resolve_service_name(name)
        service = _ActionService(self._node, kind, full, callback, self._group, qos, own=True)
        self._node._ros_keep(service)
        return service

    async def _on_goal(self, request: Any, respond: Any) -> None:
        key = bytes(request.goal_id.uuid)
        response = self.action_type.Impl.SendGoalService.Response()
        info = message("action_msgs/msg/GoalInfo")(goal_id=request.goal_id)
        info.stamp = response.stamp = self._node.get_clock().now().to_msg()
        if key in self._goal_handles:
            respond(response)
            return
        answer = await await_call(self._goal_callback, request.goal)
        if not isinstance(answer, GoalResponse):
            self._node.get_logger().warning("Goal request callback did not return a valid GoalResponse type")
        response.accepted = answer == GoalResponse.ACCEPT
        if response.accepted:
            handle = ServerGoalHandle(self, info, request.goal)
            self._goal_handles[key], self._results[key] = handle, Future()
            self.publish_status()
        respond(response)
        if response.accepted:
            call(self._handle_accepted_callback, self._goal_handles[key])

    async def _on_cancel(self, request: Any, respond: Any) -> None:
        kind = self.action_type.Impl.CancelGoalService
        response = kind.Response()
        wanted = self._chosen(request.goal_info)
        if not wanted and any(request.goal_info.goal_id.uuid):
            known = self._goal_handles.get(bytes(request.goal_info.goal_id.uuid))
            response.return_code = UNKNOWN_GOAL if known is None else TERMINATED
        for handle in wanted:
            answer = await await_call(self._cancel_callback, handle)
            if answer == CancelResponse.ACCEPT and handle.status in (ACCEPTED, EXECUTING):
                handle._update_state("CANCEL_GOAL")
                response.goals_canceling.append(handle._goal_info)
        if wanted and not response.goals_canceling:
            response.return_code = REJECTED
        respond(response)

    def _chosen(self, info: Any) -> list[ServerGoalHandle]:
        """Return the goals that a cancel request means: by identifier, by time, or all."""
        key, stamp = bytes(info.goal_id.uuid), (info.stamp.sec, info.stamp.nanosec)
        found = []
        for own, handle in self._goal_handles.items():
            accepted = handle._goal_info.stamp
            older = stamp != (0, 0) and (accepted.sec, accepted.nanosec) <= stamp
            every = not any(key) and stamp == (0, 0)
            if handle.status in (ACCEPTED, EXECUTING) and (every or older or own == key):
                found.append(handle)
        return found

    def _on_result(self, request: Any, respond: Any) -> None:
        future = self._results.get(bytes(request.goal_id.uuid))
        if future is None:
            respond(self.action_type.Impl.GetResultService.Response(status=UNKNOWN))
            return
        future.add_done_callback(lambda done: respond(done.result()))

    def notify_execute(self, goal_handle: ServerGoalHandle, execute_callback: Any) -> None:
        """Let the executor run the execute callback."""
        callback = execute_callback or self._execute_callback
        executor = self._node.executor
        if executor is None:
            raise RuntimeError("the node of the action server is in no executor")
        executor.create_task(self._execute_goal, callback, goal_handle)

    async def _execute_goal(self, execute_callback: Any, handle: ServerGoalHandle) -> None:
        key = bytes(handle.goal_id.uuid)
        try:
            result = await await_call(execute_callback, handle)
        except Exception as e:
            self._node.get_logger().error(f"Error raised in execute callback: {e}")
            result = None
        if handle.is_active:
            self._node.get_logger().warning(f"Goal state not set, assuming aborted. Goal ID: {handle.goal_id.uuid}")
            handle.abort()
        result = handle._response if result is None and handle._response is not None else result
        result = self.action_type.Result() if result is None else result
        if not isinstance(result, self.action_type.Result):
            error = TypeError(f"execute callback must return a {self.action_type.__name__}.Result, not {result!r}")
            system().failed(f"action {self._action_name}", error)
            raise error
        response = self.action_type.Impl.GetResultService.Response(status=handle.status, result=result)
        self._results[key].set_result(response)

    def publish_status(self) -> None:
        """Publish the states of all goals."""
        status = message("action_msgs/msg/GoalStatus")
        statuses = self.action_type.Impl.GoalStatusMessage()
        statuses.status_list = [status(goal_info=h._goal_info, status=h.status) for h in self._goal_handles.values()]
        self._status.publish(statuses)

    def publish_feedback(self, feedback: Any) -> None:
        """Publish feedback."""
        self._feedback.publish(feedback)

    def register_handle_accepted_callback(self, handle_accepted_callback: Any) -> None:
        self._handle_accepted_callback = handle_accepted_callback or default_handle_accepted_callback

    def register_goal_callback(self, goal_callback: Any) -> None:
        self._goal_callback = goal_callback or default_goal_callback

    def register_cancel_callback(self, cancel_callback: Any) -> None:
        self._cancel_callback = cancel_callback or default_cancel_callback

    def register_execute_callback(self, execute_callback: Any) -> None:
        if not callable(execute_callback):
            raise TypeError("Failed to register goal execution callback: not callable")
        self._execute_callback = execute_callback

    def destroy(self) -> None:
        for service in self._services:
            service.destroy()
        self._feedback.destroy()
        self._status.destroy()
