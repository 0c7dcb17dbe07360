"""Lifecycle nodes."""

from __future__ import annotations

from typing import Any

from sitaf_ros.callback_names import callback_name
from sitaf_ros.current import message, system

from ..node import Node
from ..qos import QoSProfile, qos_profile_services_default
from .managed_entity import ManagedEntity
from .publisher import LifecyclePublisher
from .states import (
    ALL,
    ERROR_PROCESSING,
    FINALIZED,
    TRANSITIONS,
    UNCONFIGURED,
    LifecycleState,
    Transition,
    TransitionCallbackReturn,
    available,
)

SUCCESS, FAILURE, ERROR = TransitionCallbackReturn
ON_ERROR_SUCCESS = 60


class LifecycleNodeMixin(ManagedEntity):
    """What makes a node a lifecycle node."""

    _ros_is_lifecycle = True
    create_publisher: Any
    _ros_create_own_service: Any
    get_logger: Any
    get_clock: Any

    def _ros_begin_lifecycle(self, communicates: bool = True) -> None:
        """Make services and the topic of transitions."""
        self._ros_managed_entities: list[ManagedEntity] = []
        self._ros_state = UNCONFIGURED
        self._ros_event_type = message("lifecycle_msgs/msg/TransitionEvent")
        self._ros_transition_event = self.create_publisher(
            self._ros_event_type, "~/transition_event", QoSProfile(depth=10)
        )
        if communicates:
            for name, kind in (
                ("change_state", "ChangeState"),
                ("get_state", "GetState"),
                ("get_available_states", "GetAvailableStates"),
                ("get_available_transitions", "GetAvailableTransitions"),
                ("get_transition_graph", "GetAvailableTransitions"),
            ):
                service = message(f"lifecycle_msgs/srv/{kind}")
                self._ros_create_own_service(
                    service, f"~/{name}", getattr(self, f"_ros_{name}"), qos_profile_services_default
                )

    # The user's part.

    def add_managed_entity(self, entity: ManagedEntity) -> None:
        self._ros_managed_entities.append(entity)

    def _ros_all(self, callback: str, state: LifecycleState) -> TransitionCallbackReturn:
        for entity in self._ros_managed_entities:
            result = getattr(entity, callback)(state)
            if result is not SUCCESS:
                return result
        return SUCCESS

    def on_configure(self, state: LifecycleState) -> TransitionCallbackReturn:
        return self._ros_all("on_configure", state)

    def on_cleanup(self, state: LifecycleState) -> TransitionCallbackReturn:
        return self._ros_all("on_cleanup", state)

    def on_shutdown(self, state: LifecycleState) -> TransitionCallbackReturn:
        return self._ros_all("on_shutdown", state)

    def on_activate(self, state: LifecycleState) -> TransitionCallbackReturn:
        return self._ros_all("on_activate", state)

    def on_deactivate(self, state: LifecycleState) -> TransitionCallbackReturn:
        return self._ros_all("on_deactivate", state)

    def on_error(self, state: LifecycleState) -> TransitionCallbackReturn:
        return self._ros_all("on_error", state)

    def create_lifecycle_publisher(self, *args: Any, **kwargs: Any) -> LifecyclePublisher:
        publisher = self.create_publisher(*args, publisher_class=LifecyclePublisher, **kwargs)
        self.add_managed_entity(publisher)
        return publisher

    def destroy_lifecycle_publisher(self, publisher: LifecyclePublisher) -> bool:
        if publisher in self._ros_managed_entities:
            self._ros_managed_entities.remove(publisher)
        publisher.destroy()
        return True

    def trigger_configure(self) -> TransitionCallbackReturn:
        return self._ros_trigger_label("configure")

    def trigger_cleanup(self) -> TransitionCallbackReturn:
        return self._ros_trigger_label("cleanup")

    def trigger_activate(self) -> TransitionCallbackReturn:
        return self._ros_trigger_label("activate")

    def trigger_deactivate(self) -> TransitionCallbackReturn:
        return self._ros_trigger_label("deactivate")

    def trigger_shutdown(self) -> TransitionCallbackReturn:
        return self._ros_trigger_label("shutdown")

    def _ros_trigger_label(self, label: str) -> TransitionCallbackReturn:
        transition = next((t for t in available(self._ros_state) if t.label == label), None)
        if transition is None:
            raise RuntimeError(f"Transition is not registered: '{label}' from the state '{self._ros_state.label}'")
        return self._ros_trigger(transition)

    # The state machine.

    def _ros_trigger(self, transition: Transition) -> TransitionCallbackReturn:
        start = self._ros_state
        self._ros_go(transition.number, transition.label, transition.during)
        result = self._ros_call(transition.callback, start)
        if result is ERROR:
            self._ros_go(transition.first_result + 2, "transition_error", ERROR_PROCESSING)
            handled = self._ros_call("on_error", start)
            number = ON_ERROR_SUCCESS + (SUCCESS, FAILURE, ERROR).index(handled)
            self._ros_go(
                number, f"transition_{handled.name.lower()}", UNCONFIGURED if handled is SUCCESS else FINALIZED
            )
            return ERROR
        target = transition.success if result is SUCCESS else transition.failure
        number = transition.first_result + (SUCCESS, FAILURE).index(result)
        self._ros_go(number, f"transition_{result.name.lower()}", target)
        return result

    def _ros_go(self, number: int, label: str, target: LifecycleState) -> None:
        start, self._ros_state = self._ros_state, target
        event = self._ros_event_type(timestamp=self.get_clock().now().nanoseconds)
        event.transition.id, event.transition.label = number, label
        event.start_state.id, event.start_state.label = start.state_id, start.label
        event.goal_state.id, event.goal_state.label = target.state_id, target.label
        self._ros_transition_event.publish(event)

    def _ros_call(self, name: str, state: LifecycleState) -> TransitionCallbackReturn:
        callback = getattr(self, name)
        try:
            result = callback(state)
        except Exception as e:
            self.get_logger().error(f"Error occurred while executing transition callback {name}: {e}")
            if type(self).on_error is LifecycleNodeMixin.on_error or name == "on_error":
                # The node does not handle errors of transitions, so the test reports them.
                system().failed(f"callback {callback_name(callback)}", e)
            return ERROR
        if not isinstance(result, TransitionCallbackReturn):
            self.get_logger().error(f"{callback_name(callback)} must return a TransitionCallbackReturn, not {result!r}")
            return ERROR
        return result

    # Services.

    def _ros_change_state(self, request: Any, response: Any) -> Any:
        wanted = request.transition
        found = [t for t in available(self._ros_state) if t.label == wanted.label or t.number == wanted.id]
        if wanted.label:
            found = [t for t in found if t.label == wanted.label]
        if not found:
            self.get_logger().warn(
                f"No transition matching {wanted.label or wanted.id} found for current state {self._ros_state.label}"
            )
            if not wanted.label:
                system().unobserved.warn(
                    f"rclpy of ROS 2 ends a node that is asked for the transition {wanted.id} in the state "
                    f"{self._ros_state.label}; here it answers success=False"
                )
            return response
        response.success = self._ros_trigger(found[0]) is SUCCESS
        return response

    def _ros_get_state(self, request: Any, response: Any) -> Any:
        response.current_state.id, response.current_state.label = self._ros_state.state_id, self._ros_state.label
        return response

    def _ros_get_available_states(self, request: Any, response: Any) -> Any:
        response.available_states = [_state(state) for state in ALL]
        return response

    def _ros_get_available_transitions(self, request: Any, response: Any) -> Any:
        response.available_transitions = [_description(t) for t in available(self._ros_state)]
        return response

    def _ros_get_transition_graph(self, request: Any, response: Any) -> Any:
        response.available_transitions = [_description(t) for t in TRANSITIONS]
        return response


def _state(state: LifecycleState) -> Any:
    return message("lifecycle_msgs/msg/State")(id=state.state_id, label=state.label)


def _description(transition: Transition) -> Any:
    made = message("lifecycle_msgs/msg/TransitionDescription")()
    made.transition.id, made.transition.label = transition.number, transition.label
    made.start_state, made.goal_state = _state(transition.start), _state(transition.during)
    return made


class LifecycleNode(LifecycleNodeMixin, Node):
    def __init__(self, node_name: str, *, enable_communication_interface: bool = True, **kwargs: Any) -> None:
        Node.__init__(self, node_name, **kwargs)
        self._ros_begin_lifecycle(enable_communication_interface)
