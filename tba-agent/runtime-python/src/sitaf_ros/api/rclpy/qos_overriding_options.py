"""Which QoS policies parameters may change."""

from __future__ import annotations

from typing import Any

from .duration import Duration
from .qos import QoSPolicyKind, QoSProfile

_DEFAULT = (QoSPolicyKind.HISTORY, QoSPolicyKind.DEPTH, QoSPolicyKind.RELIABILITY)


class QosCallbackResult:
    def __init__(self) -> None:
        self.successful = False
        self.reason = ""


class InvalidQosOverridesError(Exception):
    pass


class QoSOverridingOptions:
    def __init__(self, policy_kinds: Any, *, callback: Any = None, entity_id: str | None = None) -> None:
        self.policy_kinds, self.callback, self.entity_id = tuple(policy_kinds), callback, entity_id

    @classmethod
    def with_default_policies(cls, *, callback: Any = None, entity_id: str | None = None) -> QoSOverridingOptions:
        return cls(_DEFAULT, callback=callback, entity_id=entity_id)


def override(node: Any, kind: str, topic: str, qos: QoSProfile, options: QoSOverridingOptions) -> QoSProfile:
    """Declare the parameters `qos_overrides.TOPIC.KIND.POLICY` and return the changed profile."""
    changed = QoSProfile(
        history=qos.history,
        depth=qos.depth,
        reliability=qos.reliability,
        durability=qos.durability,
        lifespan=qos.lifespan,
        deadline=qos.deadline,
        liveliness=qos.liveliness,
        liveliness_lease_duration=qos.liveliness_lease_duration,
    )
    suffix = f"_{options.entity_id}" if options.entity_id else ""
    for policy in options.policy_kinds:
        name = QoSPolicyKind(policy).name.lower()
        current = getattr(changed, name)
        plain = current if isinstance(current, int) and not hasattr(current, "short_key") else _plain(current)
        value = node.declare_parameter(f"qos_overrides.{topic}.{kind}{suffix}.{name}", plain).value
        setattr(changed, name, _policy(current, value))
    if options.callback is not None:
        result = options.callback(changed)
        if not result.successful:
            raise InvalidQosOverridesError(f"{topic}: {result.reason}")
    return changed


def _policy(current: Any, value: Any) -> Any:
    if isinstance(current, Duration):
        return Duration(nanoseconds=value)
    kind: Any = type(current)
    return kind[value.upper()] if hasattr(current, "short_key") else value


def _plain(value: Any) -> Any:
    return value.short_key if hasattr(value, "short_key") else value.nanoseconds
