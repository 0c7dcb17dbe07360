"""Publishers."""

from __future__ import annotations

from typing import Any

from sitaf_ros import graph
from sitaf_ros.current import note_later_release, system
from sitaf_ros.serialization import Reader

from .exceptions import InvalidHandle
from .qos import quality_of


class Publisher:
    def __class_getitem__(cls, item: Any) -> Any:
        return cls

    def __init__(self, node: Any, msg_type: Any, topic: str, qos_profile: Any, events: Any) -> None:
        self._node, self.msg_type, self.topic, self.qos_profile = node, msg_type, topic, qos_profile
        self._events = events
        self.destroyed = False
        name = msg_type._definition.name
        self._publication = graph.Publication(
            topic, name, quality_of(qos_profile), events, node.get_fully_qualified_name()
        )
        events.publication = self._publication
        system().graph.add_publication(self._publication)

    @property
    def topic_name(self) -> str:
        return self.topic

    @property
    def handle(self) -> Publisher:
        return self

    @property
    def event_handlers(self) -> list[Any]:
        return self._events.handlers

    @property
    def logger_name(self) -> str:
        return self._node.get_logger().name

    def publish(self, msg: Any) -> None:
        if self.destroyed:
            raise InvalidHandle("cannot use Destroyable because destruction was requested")
        if isinstance(msg, bytes):
            classes = system().application.classes
            msg = Reader(msg, classes.message).message(self.msg_type)
        elif not isinstance(msg, self.msg_type):
            raise TypeError(f"Expected {self.msg_type}, got {type(msg)}")
        system().graph.publish(self._publication, msg)
        self._events.message()

    def get_subscription_count(self) -> int:
        current = system().graph
        return sum(current.matches(self._publication, s) for s in current.subscriptions.get(self.topic, ()))

    def wait_for_all_acked(self, timeout: Any = None) -> bool:
        return True

    def assert_liveliness(self) -> None:
        self._events.assert_liveliness()

    def destroy(self) -> None:
        if not self.destroyed:
            self.destroyed = True
            system().graph.remove_publication(self._publication)
            self._node._ros_forget_publisher(self)

    def __enter__(self) -> Publisher:
        note_later_release("with on a publisher")
        return self

    def __exit__(self, *_: object) -> None:
        self.destroy()
