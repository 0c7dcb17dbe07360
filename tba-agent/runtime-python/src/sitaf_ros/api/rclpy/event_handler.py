"""QoS events of publishers and subscriptions."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import Any

from sitaf_ros.current import system
from sitaf_ros.graph import INFINITE_NS, Quality

from . import exceptions
from .entity import TIMERS, Entity, Order, QueueEntity, Work
from .qos import QoSPolicyKind

UnsupportedEventTypeError = exceptions.UnsupportedEventTypeError


class QoSPublisherEventType(IntEnum):
    RCL_PUBLISHER_OFFERED_DEADLINE_MISSED = 0
    RCL_PUBLISHER_LIVELINESS_LOST = 1
    RCL_PUBLISHER_OFFERED_INCOMPATIBLE_QOS = 2
    RCL_PUBLISHER_INCOMPATIBLE_TYPE = 3
    RCL_PUBLISHER_MATCHED = 4


class QoSSubscriptionEventType(IntEnum):
    RCL_SUBSCRIPTION_REQUESTED_DEADLINE_MISSED = 0
    RCL_SUBSCRIPTION_LIVELINESS_CHANGED = 1
    RCL_SUBSCRIPTION_REQUESTED_INCOMPATIBLE_QOS = 2
    RCL_SUBSCRIPTION_MESSAGE_LOST = 3
    RCL_SUBSCRIPTION_INCOMPATIBLE_TYPE = 4
    RCL_SUBSCRIPTION_MATCHED = 5


@dataclass
class QoSRequestedDeadlineMissedInfo:
    total_count: int = 0
    total_count_change: int = 0


@dataclass
class QoSOfferedDeadlineMissedInfo:
    total_count: int = 0
    total_count_change: int = 0


@dataclass
class QoSLivelinessLostInfo:
    total_count: int = 0
    total_count_change: int = 0


@dataclass
class QoSMessageLostInfo:
    total_count: int = 0
    total_count_change: int = 0


@dataclass
class QoSLivelinessChangedInfo:
    alive_count: int = 0
    not_alive_count: int = 0
    alive_count_change: int = 0
    not_alive_count_change: int = 0


@dataclass
class QoSRequestedIncompatibleQoSInfo:
    total_count: int = 0
    total_count_change: int = 0
    last_policy_kind: QoSPolicyKind = QoSPolicyKind.INVALID


QoSOfferedIncompatibleQoSInfo = QoSRequestedIncompatibleQoSInfo


@dataclass
class IncompatibleTypeInfo:
    total_count: int = 0
    total_count_change: int = 0


@dataclass
class QoSMatchedInfo:
    total_count: int = 0
    total_count_change: int = 0
    current_count: int = 0
    current_count_change: int = 0


QoSPublisherMatchedInfo = QoSMatchedInfo
QoSSubscriptionMatchedInfo = QoSMatchedInfo


class _EventCallbacks:
    def __init__(
        self,
        *,
        deadline: Any = None,
        liveliness: Any = None,
        incompatible_qos: Any = None,
        incompatible_type: Any = None,
        matched: Any = None,
        use_default_callbacks: bool = True,
    ) -> None:
        self.deadline, self.liveliness = deadline, liveliness
        self.incompatible_qos, self.incompatible_type, self.matched = incompatible_qos, incompatible_type, matched
        self.use_default_callbacks = use_default_callbacks


class PublisherEventCallbacks(_EventCallbacks):
    pass


class SubscriptionEventCallbacks(_EventCallbacks):
    def __init__(self, *, message_lost: Any = None, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.message_lost = message_lost


class EventHandler(QueueEntity):
    """Calls a callback with the state of an event; changes add up until it is called."""

    def __init__(self, node: Any, callback: Any, callback_group: Any, info: Any) -> None:
        super().__init__(node, callback, callback_group)
        self.callback, self.info = callback, info
        node._ros_keep(self)

    def happened(self, **values: Any) -> None:
        """Take the new state."""
        for name, value in values.items():
            added = name.endswith("_change") and bool(self.queue)
            setattr(self.info, name, getattr(self.info, name) + value if added else value)
        if not self.queue:
            self.put(system().graph.next_number(), self._call)

    def _call(self) -> Any:
        info = type(self.info)(**vars(self.info))
        for name in vars(info):
            if name.endswith("_change"):
                setattr(self.info, name, 0)
        return self.callback(info)


QoSEventHandler = EventHandler


class Overdue(Entity):
    """Runs something when nothing has happened for a time; it begins when `restart` is first called."""

    def __init__(self, node: Any, callback: Any, callback_group: Any, period_ns: int, repeats: bool) -> None:
        super().__init__(node, callback, callback_group)
        self._callback, self._period, self._repeats = callback, period_ns, repeats
        self._number = system().graph.next_number()
        self._next: int | None = None
        node._ros_keep(self)

    def restart(self) -> None:
        """Begin again."""
        self._next = system().now_ns + self._period
        self._node._ros_wake()

    def order(self) -> Order | None:
        ready = self._next is not None and self._next <= system().now_ns and not self.destroyed
        return (TIMERS, self._number) if ready else None

    def due_ns(self) -> int | None:
        return None if self.destroyed else self._next

    def take(self) -> Work | None:
        self._next = system().now_ns + self._period if self._repeats else None
        return self._callback


class EndpointEvents:
    """The events of one publisher or subscription."""

    def __init__(self, node: Any, callbacks: Any, group: Any, topic: str, subscribes: bool, quality: Quality) -> None:
        self._node, self._group, self._log = node, group, node.get_logger()
        self._topic, self._subscribes = topic, subscribes
        self.handlers: list[Any] = []
        self._matched = self._handler(callbacks, "matched", QoSMatchedInfo())
        self._incompatible = self._handler(callbacks, "incompatible_qos", QoSRequestedIncompatibleQoSInfo())
        missed = QoSRequestedDeadlineMissedInfo() if subscribes else QoSOfferedDeadlineMissedInfo()
        self._deadline = self._handler(callbacks, "deadline", missed)
        liveliness = QoSLivelinessChangedInfo() if subscribes else QoSLivelinessLostInfo()
        self._liveliness = self._handler(callbacks, "liveliness", liveliness)
        self.current, self._total, self._wrong, self._missed, self._lost = 0, 0, 0, 0, 0
        self._alive, self._dead = 0, 0
        self._deadline_timer: Overdue | None = None
        if self._deadline is not None and quality.deadline_ns < INFINITE_NS:
            self._deadline_timer = Overdue(node, self._miss, group, quality.deadline_ns, repeats=True)
        self._lease: Overdue | None = None
        if not subscribes and quality.manual_liveliness and quality.lease_ns < INFINITE_NS:
            self._lease = Overdue(node, self._lose, group, quality.lease_ns, repeats=False)
        self.is_alive = True
        self.publication: Any = None

    def _handler(self, callbacks: Any, name: str, info: Any) -> EventHandler | None:
        callback = getattr(callbacks, name, None)
        if callback is None:
            return None
        self.handlers.append(EventHandler(self._node, callback, self._group, info))
        return self.handlers[-1]

    def message(self) -> None:
        """A message was published or received."""
        if self._deadline_timer is not None:
            self._deadline_timer.restart()
        self.assert_liveliness()

    def assert_liveliness(self) -> None:
        """The publisher says that it is alive."""
        if self._lease is not None:
            self._lease.restart()
            if not self.is_alive:
                self.is_alive = True
                system().graph.alive(self.publication, is_alive=True)

    def _miss(self) -> None:
        self._missed += 1
        if self._deadline is not None:
            self._deadline.happened(total_count=self._missed, total_count_change=1)

    def _lose(self) -> None:
        self.is_alive = False
        self._lost += 1
        system().graph.alive(self.publication, is_alive=False)
        if self._liveliness is not None:
            self._liveliness.happened(total_count=self._lost, total_count_change=1)

    def alive(self, change: int, dead: int | None = None) -> None:
        """A publisher became alive or not, seen from a subscription."""
        dead = -change if dead is None else dead
        self._alive += change
        self._dead += dead
        if self._liveliness is not None and self._subscribes:
            self._liveliness.happened(
                alive_count=self._alive,
                not_alive_count=self._dead,
                alive_count_change=change,
                not_alive_count_change=dead,
            )

    def matched(self, change: int) -> None:
        """A counterpart appeared or left."""
        self.current += change
        self._total += max(0, change)
        if self._subscribes:
            self.alive(change, dead=0)
        if self._matched is not None:
            self._matched.happened(
                total_count=self._total,
                total_count_change=max(0, change),
                current_count=self.current,
                current_count_change=change,
            )

    def incompatible_with(self, policy: str) -> None:
        """A counterpart does not fit."""
        self._wrong += 1
        if self._incompatible is not None:
            kind = QoSPolicyKind.__members__.get(policy, QoSPolicyKind.INVALID)
            self._incompatible.happened(total_count=self._wrong, total_count_change=1, last_policy_kind=kind)
            return
        what = "offering" if self._subscribes else "requesting"
        self._log.warn(
            f"New {'publisher' if self._subscribes else 'subscription'} discovered on topic '{self._topic}', "
            f"{what} incompatible QoS. No messages will be {'received from' if self._subscribes else 'sent to'} it. "
            f"Last incompatible policy: {policy}"
        )


# The names of rclpy.
QoSDeadlineRequestedInfo = QoSRequestedDeadlineMissedInfo
QoSDeadlineOfferedInfo = QoSOfferedDeadlineMissedInfo
