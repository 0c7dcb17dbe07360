"""QoS events of publishers and subscriptions."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import Any

from sitaf_ros.current import system

from .entity import QueueEntity
from .qos import QoSPolicyKind


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


class MatchEvents:
    """The events of one publisher or subscription."""

    def __init__(self, node: Any, callbacks: Any, group: Any, logger: Any, topic: str, subscribes: bool) -> None:
        self._log, self._topic, self._subscribes = logger, topic, subscribes
        self._matched = self._handler(node, callbacks, "matched", group, QoSMatchedInfo())
        self._incompatible = self._handler(
            node, callbacks, "incompatible_qos", group, QoSRequestedIncompatibleQoSInfo()
        )
        self.current, self._total, self._wrong = 0, 0, 0
        self.handlers = [h for h in (self._matched, self._incompatible) if h is not None]

    @staticmethod
    def _handler(node: Any, callbacks: Any, name: str, group: Any, info: Any) -> EventHandler | None:
        callback = getattr(callbacks, name, None)
        return None if callback is None else EventHandler(node, callback, group, info)

    def matched(self, change: int) -> None:
        """A counterpart appeared or left."""
        self.current += change
        self._total += max(0, change)
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
