"""What the nodes of a case did that nothing looked at, so that a user knows what stays untested."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from sitaf_ros.graph import Graph

INFRASTRUCTURE = ("/parameter_events", "/rosout", "/clock")
ACTION_PARTS = "/_action/"


@dataclass(frozen=True)
class RosReport:
    """Names, sorted; empty where everything was looked at."""

    undeclared_parameters: tuple[str, ...] = ()
    """Overrides that no node declared."""
    unobserved_topics: tuple[str, ...] = ()
    """Topics that nodes published on and nobody subscribed to."""
    unfed_topics: tuple[str, ...] = ()
    """Topics that nodes subscribed to and that had no message."""
    uncalled_callbacks: tuple[str, ...] = ()
    incompatible_qos: tuple[str, ...] = ()
    different_types: tuple[str, ...] = ()
    """Topics whose publisher and subscription have different types."""
    warnings: tuple[str, ...] = ()


class Unobserved:
    """Collects during a case."""

    def __init__(self) -> None:
        self._callbacks: dict[str, int] = {}
        self._warnings: list[str] = []
        self._overrides: set[str] = set()
        self._declared: set[str] = set()

    def callback(self, name: str) -> None:
        """A node registered a callback."""
        self._callbacks.setdefault(name, 0)

    def called(self, name: str) -> None:
        """A callback runs."""
        self._callbacks[name] = self._callbacks.get(name, 0) + 1

    def warn(self, text: str) -> None:
        """Note something a user should know."""
        if text not in self._warnings:
            self._warnings.append(text)

    def overridden(self, names: Any) -> None:
        """A node has these overrides."""
        self._overrides.update(names)

    def declared(self, name: str) -> None:
        """A node declared a parameter."""
        self._declared.add(name)

    def warnings(self) -> list[str]:
        """Return what was noted so far."""
        return list(self._warnings)

    def report(self, graph: Graph, slow_polls: int) -> RosReport:
        """Return what is known now."""
        publications, subscriptions = graph.past_publications, graph.past_subscriptions
        sent = {p.topic for p in publications if p.node is not None and p.sent and _is_users(p.topic)}
        listened = {s.topic for s in subscriptions}
        received = {s.topic for s in subscriptions if s.node is not None and s.received}
        asked = {s.topic for s in subscriptions if s.node is not None and _is_users(s.topic)}
        if slow_polls:
            self.warn("a loop of the node never waits; each 500 looks at the clock or a queue count as 1 ms")
        return RosReport(
            undeclared_parameters=tuple(sorted(self._overrides - self._declared)),
            unobserved_topics=tuple(sorted(sent - listened)),
            unfed_topics=tuple(sorted(asked - received)),
            uncalled_callbacks=tuple(sorted(name for name, times in self._callbacks.items() if not times)),
            incompatible_qos=tuple(sorted(graph.incompatible)),
            different_types=tuple(sorted(graph.different_types)),
            warnings=tuple(sorted(self._warnings)),
        )


def _is_users(topic: str) -> bool:
    return topic not in INFRASTRUCTURE and ACTION_PARTS not in topic
