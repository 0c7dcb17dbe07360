"""Calls back when parameters of any node change."""

from __future__ import annotations

from typing import Any

from sitaf_ros.current import message

from .qos import qos_profile_parameter_events


class ParameterEventCallbackHandle:
    def __init__(self, callback: Any) -> None:
        self.callback = callback


class ParameterCallbackHandle:
    def __init__(self, parameter_name: str, node_name: str, callback: Any) -> None:
        self.parameter_name, self.node_name, self.callback = parameter_name, node_name, callback


class ParameterEventHandler:
    def __init__(self, node: Any, qos_profile: Any = qos_profile_parameter_events) -> None:
        self.node = node
        self._parameters: list[ParameterCallbackHandle] = []
        self._events: list[ParameterEventCallbackHandle] = []
        self.parameter_event_subscription = node.create_subscription(
            message("rcl_interfaces/msg/ParameterEvent"), "/parameter_events", self._on_event, qos_profile
        )

    def destroy(self) -> None:
        self.node.destroy_subscription(self.parameter_event_subscription)

    def _on_event(self, event: Any) -> None:
        for handle in list(self._parameters):
            found = self.get_parameter_from_event(event, handle.parameter_name, handle.node_name)
            if found is not None:
                handle.callback(found)
        for handle in list(self._events):
            handle.callback(event)

    @staticmethod
    def get_parameter_from_event(event: Any, parameter_name: str, node_name: str) -> Any:
        if event.node != node_name:
            return None
        changed = [*event.new_parameters, *event.changed_parameters]
        return next((p for p in reversed(changed) if p.name == parameter_name), None)

    @staticmethod
    def get_parameters_from_event(event: Any) -> Any:
        return iter([*event.new_parameters, *event.changed_parameters])

    def add_parameter_event_callback(self, callback: Any) -> ParameterEventCallbackHandle:
        self._events.insert(0, ParameterEventCallbackHandle(callback))
        return self._events[0]

    def remove_parameter_event_callback(self, handle: ParameterEventCallbackHandle) -> None:
        self._events.remove(handle)

    def add_parameter_callback(self, parameter_name: str, node_name: str, callback: Any) -> ParameterCallbackHandle:
        full = node_name or self.node.get_fully_qualified_name()
        if not full.startswith("/"):
            full = f"{self.node.get_namespace().rstrip('/')}/{full}"
        self._parameters.insert(0, ParameterCallbackHandle(parameter_name, full, callback))
        return self._parameters[0]

    def remove_parameter_callback(self, handle: ParameterCallbackHandle) -> None:
        self._parameters.remove(handle)
