"""What the installed ROS 2 tells about the nodes of a case, for the report of what nothing looked at."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

from sitaf_ros.settings import flat, is_parameter_file
from sitaf_ros.unobserved import ACTION_PARTS, INFRASTRUCTURE, RosReport

if TYPE_CHECKING:
    from sitaf_ros.installed.system import InstalledSystem

_LIST_PARAMETERS = "rcl_interfaces/srv/ListParameters"
_LOOKS = 200


class Observed:
    """Looks at topics and parameters; `node` is the test application's."""

    def __init__(self, system: InstalledSystem, node: Any) -> None:
        self._system = system
        self._node = node
        self._fed: set[str] = set()
        self._sent: set[str] = set()
        self._asked: set[str] = set()
        self._declared: set[str] | None = None

    def fed(self, topic: str) -> None:
        """The test application published there."""
        self._fed.add(topic)

    def graph(self) -> str:
        """Everything that is there, to see whether it changes."""
        topics = {name: self._ends(name) for name, _ in self._node.get_topic_names_and_types()}
        return json.dumps([topics, self._node.get_service_names_and_types()], sort_keys=True)

    def _ends(self, topic: str) -> list[list[str]]:
        return [
            sorted(f"{end.node_namespace}/{end.node_name}" for end in ends)
            for ends in (
                self._node.get_publishers_info_by_topic(topic),
                self._node.get_subscriptions_info_by_topic(topic),
            )
        ]

    def look(self) -> None:
        """Note the topics and parameters of the nodes, which must still be there."""
        own = f"{self._node.get_namespace()}/{self._node.get_name()}"
        for topic, _ in self._node.get_topic_names_and_types():
            if topic in INFRASTRUCTURE or ACTION_PARTS in topic:
                continue
            publishers, subscribers = self._ends(topic)
            if any(end != own for end in publishers) and not subscribers:
                self._sent.add(topic)
            if (
                any(end != own for end in subscribers)
                and topic not in self._fed
                and not any(end != own for end in publishers)
            ):
                self._asked.add(topic)
        given = self._given()
        if given:
            self._declared = self._list_parameters()

    def _given(self) -> set[str]:
        parameters = self._system.settings.parameters
        # Of a file only the nodes themselves know which entries are theirs.
        return set() if is_parameter_file(parameters) else set(flat(parameters)) - {"use_sim_time"}

    def _list_parameters(self) -> set[str] | None:
        found: set[str] = set()
        for name, types in self._node.get_service_names_and_types():
            if _LIST_PARAMETERS not in types:
                continue
            call = self._system.call_service(name, _LIST_PARAMETERS, {})
            for _ in range(_LOOKS):
                if call.done or call.error:
                    break
                self._system.run_until(self._system.now_ns + 1_000_000)
            if not call.done:
                return None
            found.update(call.response.result.names)
        return found

    def report(self, warnings: list[str]) -> RosReport:
        """Return what is known."""
        declared = self._declared
        return RosReport(
            undeclared_parameters=() if declared is None else tuple(sorted(self._given() - declared)),
            unobserved_topics=tuple(sorted(self._sent)),
            unfed_topics=tuple(sorted(self._asked)),
            warnings=tuple(sorted(warnings)),
        )
