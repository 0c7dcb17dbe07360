"""Action clients."""

from __future__ import annotations

import uuid
from typing import Any

from sitaf_ros.current import message, system

from ..client import wait_until
from ..qos import (
    QoSProfile,
    qos_profile_action_status_default,
    qos_profile_services_default,
)
from ..task import Future
from ..type_support import check_for_type_support
from ..user_callback import register

UNKNOWN = 0


class ClientGoalHandle:
    def __class_getitem__(cls, item: Any) -> Any:
        return cls

    def __init__(self, action_client: ActionClient, goal_id: Any, goal_response: Any) -> None:
        self._action_client, self._goal_id, self._goal_response = action_client, goal_id, goal_response
        self._status = UNKNOWN

    def __eq__(self, other: object) -> bool:
        return isinstance(other, ClientGoalHandle) and self.goal_id == other.goal_id

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        return f"ClientGoalHandle <id={self.goal_id.uuid}, accepted={self.accepted}, status={self.status}>"

    @property
    def goal_id(self) -> Any:
        return self._goal_id

    @property
    def stamp(self) -> Any:
        return self._goal_response.stamp

    @property
    def accepted(self) -> bool:
        return self._goal_response.accepted

    @property
    def status(self) -> int:
        return self._status

    def cancel_goal(self) -> Any:
        return wait_for(self.cancel_goal_async())

    def cancel_goal_async(self) -> Future:
        return self._action_client._cancel_goal_async(self)

    def get_result(self) -> Any:
        return wait_for(self.get_result_async())

    def get_result_async(self) -> Future:
        return self._action_client._get_result_async(self)


class ActionClient:
    def __class_getitem__(cls, item: Any) -> Any:
        return cls

    def __init__(
        self,
        node: Any,
        action_type: Any,
        action_name: str,
        *,
        callback_group: Any = None,
        goal_service_qos_profile: Any = qos_profile_services_default,
        result_service_qos_profile: Any = qos_profile_services_default,
        cancel_service_qos_profile: Any = qos_profile_services_default,
        feedback_sub_qos_profile: Any = None,
        status_sub_qos_profile: Any = qos_profile_action_status_default,
    ) -> None:
        check_for_type_support(action_type)
        self._node, self._action_type, self._action_name = node, action_type, action_name
        group = callback_group or node.default_callback_group
        kinds, base = action_type.Impl, f"{action_name}/_action"

        def client(kind: Any, name: str, qos: Any) -> Any:
            return node.create_client(kind, f"{base}/{name}", qos_profile=qos, callback_group=group)

        self._goal = client(kinds.SendGoalService, "send_goal", goal_service_qos_profile)
        self._cancel = client(kinds.CancelGoalService, "cancel_goal", cancel_service_qos_profile)
        self._result = client(kinds.GetResultService, "get_result", result_service_qos_profile)
        self._feedback_callbacks: dict[bytes, Any] = {}
        self._handles: dict[bytes, ClientGoalHandle] = {}
        self._subscriptions = [
            node.create_subscription(
                kinds.FeedbackMessage,
                f"{base}/feedback",
                self._feedback,
                feedback_sub_qos_profile or QoSProfile(depth=10),
                callback_group=group,
            ),
            node.create_subscription(
                kinds.GoalStatusMessage, f"{base}/status", self._status, status_sub_qos_profile, callback_group=group
            ),
        ]

    def _feedback(self, feedback: Any) -> None:
        callback = self._feedback_callbacks.get(bytes(feedback.goal_id.uuid))
        if callback is not None:
            from ..user_callback import call

            call(callback, feedback)

    def _status(self, statuses: Any) -> None:
        for status in statuses.status_list:
            handle = self._handles.get(bytes(status.goal_info.goal_id.uuid))
            if handle is not None:
                handle._status = status.status

    def send_goal(self, goal: Any, feedback_callback: Any = None, goal_uuid: Any = None) -> Any:
        handle = wait_for(self.send_goal_async(goal, feedback_callback, goal_uuid))
        if handle is None or not handle.accepted:
            return None
        return handle.get_result()

    def send_goal_async(self, goal: Any, feedback_callback: Any = None, goal_uuid: Any = None) -> Future:
        if not isinstance(goal, self._action_type.Goal):
            raise TypeError(f"expected {self._action_type.Goal}, got {type(goal)}")
        request = self._action_type.Impl.SendGoalService.Request()
        request.goal_id = goal_uuid or message("unique_identifier_msgs/msg/UUID")(uuid=list(uuid.uuid4().bytes))
        request.goal = goal
        key = bytes(request.goal_id.uuid)
        if feedback_callback is not None:
            register(feedback_callback)
            self._feedback_callbacks[key] = feedback_callback
        future = Future()

        def answered(response: Future) -> None:
            handle = ClientGoalHandle(self, request.goal_id, response.result())
            if handle.accepted:
                self._handles[key] = handle
            else:
                self._feedback_callbacks.pop(key, None)
            if not future.cancelled():
                future.set_result(handle)

        answered.runs_at_once = True  # type: ignore[attr-defined]
        self._goal.call_async(request).add_done_callback(answered)
        return future

    def _cancel_goal_async(self, handle: ClientGoalHandle) -> Future:
        request = self._action_type.Impl.CancelGoalService.Request()
        request.goal_info.goal_id = handle.goal_id
        return self._cancel.call_async(request)

    def _get_result_async(self, handle: ClientGoalHandle) -> Future:
        request = self._action_type.Impl.GetResultService.Request(goal_id=handle.goal_id)
        future = self._result.call_async(request)

        def done(response: Future) -> None:
            handle._status = response.result().status
            self._feedback_callbacks.pop(bytes(handle.goal_id.uuid), None)

        done.runs_at_once = True  # type: ignore[attr-defined]
        future.add_done_callback(done)
        return future

    def server_is_ready(self) -> bool:
        return all(client.service_is_ready() for client in (self._goal, self._cancel, self._result))

    def wait_for_server(self, timeout_sec: float | None = None) -> bool:
        return wait_until(self.server_is_ready, timeout_sec, self._node.context)

    def destroy(self) -> None:
        for client in (self._goal, self._cancel, self._result):
            self._node.destroy_client(client)
        for subscription in self._subscriptions:
            self._node.destroy_subscription(subscription)


def wait_for(future: Future) -> Any:
    """Wait until another thread completes a future."""
    threads = system().threads
    me = threads.current()

    def done(_: Future) -> None:
        threads.wake(me)

    done.runs_at_once = True  # type: ignore[attr-defined]
    future.add_done_callback(done)
    while not future.done():
        threads.wait(None)
    return future.result()
