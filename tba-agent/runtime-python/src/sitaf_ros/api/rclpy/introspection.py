"""Service introspection: requests and responses on the topic `SERVICE/_service_event`."""

from __future__ import annotations

from typing import Any

from sitaf_ros.current import message

from .service_introspection import ServiceIntrospectionState


class Introspection:
    """Publishes the events of one service or client while it is switched on."""

    def __init__(self, node: Any, srv_type: Any, name: str) -> None:
        self._node, self._type, self._name = node, srv_type, name
        self._publisher: Any = None
        self._clock: Any = None
        self._state = ServiceIntrospectionState.OFF

    def configure(self, clock: Any, qos_profile: Any, state: Any) -> None:
        """Set the state."""
        self._state, self._clock = ServiceIntrospectionState(state), clock
        if self._state is ServiceIntrospectionState.OFF:
            if self._publisher is not None:
                self._publisher.destroy()
                self._publisher = None
        elif self._publisher is None:
            self._publisher = self._node.create_publisher(self._type.Event, f"{self._name}/_service_event", qos_profile)

    def event(self, kind: int, number: int, request: Any = None, response: Any = None) -> None:
        """Publish an event: 0 request sent, 1 request received, 2 response sent, 3 response received."""
        if self._publisher is None:
            return
        info = message("service_msgs/msg/ServiceEventInfo")(event_type=kind, sequence_number=number)
        info.stamp = self._clock.now().to_msg()
        event = self._type.Event(info=info)
        if self._state is ServiceIntrospectionState.CONTENTS:
            event.request = [] if request is None else [request]
            event.response = [] if response is None else [response]
        self._publisher.publish(event)
