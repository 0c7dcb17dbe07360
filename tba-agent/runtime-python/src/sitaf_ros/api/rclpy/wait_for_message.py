"""Waits for one message."""

from __future__ import annotations

from typing import Any

from .qos import QoSProfile
from .task import Future


def wait_for_message(
    msg_type: Any, node: Any, topic: str, *, qos_profile: Any = 1, time_to_wait: float = -1
) -> tuple[bool, Any]:
    from . import spin_until_future_complete

    future = Future()
    subscription = node.create_subscription(
        msg_type, topic, lambda m: None if future.done() else future.set_result(m), _profile(qos_profile)
    )
    try:
        spin_until_future_complete(node, future, timeout_sec=None if time_to_wait < 0 else time_to_wait)
    finally:
        node.destroy_subscription(subscription)
    return future.done(), future.result() if future.done() else None


def _profile(qos: Any) -> Any:
    return qos if isinstance(qos, QoSProfile) else QoSProfile(depth=int(qos))
