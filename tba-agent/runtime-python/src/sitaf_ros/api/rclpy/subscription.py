"""Subscriptions."""

from __future__ import annotations

import inspect
from enum import Enum
from typing import Any, TypedDict

from sitaf_ros import graph
from sitaf_ros.current import system
from sitaf_ros.graph import Delivery
from sitaf_ros.serialization import serialize

from .entity import QueueEntity
from .qos import quality_of


class MessageInfo(TypedDict):
    """What comes with a message to a callback with two parameters: a dictionary; times are in ns."""

    source_timestamp: int
    received_timestamp: int
    publication_sequence_number: int
    reception_sequence_number: int


def _info(delivery: Delivery) -> MessageInfo:
    stamp = system().ros_time_ns() - (system().now_ns - delivery.time_ns)
    return MessageInfo(
        source_timestamp=stamp,
        received_timestamp=stamp,
        publication_sequence_number=delivery.number,
        reception_sequence_number=delivery.number,
    )


class Subscription(QueueEntity):
    class CallbackType(Enum):
        MessageOnly = 0
        WithMessageInfo = 1

    def __init__(
        self, node: Any, msg_type: Any, topic: str, callback: Any, group: Any, qos_profile: Any, raw: bool, events: Any
    ) -> None:
        super().__init__(node, callback, group)
        self.msg_type, self.topic, self.qos_profile, self.raw = msg_type, topic, qos_profile, raw
        self._events = events
        self.callback = callback
        name = msg_type._definition.name
        quality = quality_of(qos_profile, subscribes=True)
        self._depth = None if quality.keep_all else max(1, quality.depth)
        self._subscribed = graph.Subscribed(topic, name, quality, self, node.get_fully_qualified_name())

    def connect(self) -> None:
        """Begin to receive."""
        system().graph.add_subscription(self._subscribed)

    @property
    def callback(self) -> Any:
        return self._callback

    @callback.setter
    def callback(self, value: Any) -> None:
        self._callback = value
        self._callback_type = self.CallbackType.MessageOnly
        try:
            inspect.signature(value).bind(object())
        except TypeError:
            try:
                inspect.signature(value).bind(object(), object())
            except TypeError as e:
                raise RuntimeError(
                    "Subscription callback should be either be callable with one argument (to get only the message) "
                    "or two (to get message and message info)"
                ) from e
            self._callback_type = self.CallbackType.WithMessageInfo
        except ValueError:
            pass  # a built-in function without a signature takes the message

    @property
    def topic_name(self) -> str:
        return self.topic

    @property
    def event_handlers(self) -> list[Any]:
        return self._events.handlers

    def get_publisher_count(self) -> int:
        current = system().graph
        return sum(current.matches(p, self._subscribed) for p in current.publications.get(self.topic, ()))

    def matched(self, change: int) -> None:
        self._events.matched(change)

    def incompatible_with(self, policy: str) -> None:
        self._events.incompatible_with(policy)

    def alive(self, change: int) -> None:
        self._events.alive(change)

    def receive(self, delivery: Delivery) -> None:
        """Queue a message; the oldest goes when more than `depth` wait."""
        while self._depth is not None and len(self.queue) >= self._depth:
            self.queue.popleft()
        self._events.message()
        self.put(delivery.number, lambda: self._call(delivery))

    def _call(self, delivery: Delivery) -> Any:
        value = serialize(delivery.message) if self.raw else delivery.message
        if self._callback_type is self.CallbackType.MessageOnly:
            return self._callback(value)
        return self._callback(value, _info(delivery))

    def destroy(self) -> None:
        if not self.destroyed:
            super().destroy()
            system().graph.remove_subscription(self._subscribed)
