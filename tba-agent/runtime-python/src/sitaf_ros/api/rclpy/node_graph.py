"""What a node can ask about other nodes, topics and services."""

from __future__ import annotations

from typing import Any

from sitaf_ros.current import system

from .qos import DurabilityPolicy, HistoryPolicy, QoSProfile, ReliabilityPolicy
from .topic_endpoint_info import TopicEndpointInfo, TopicEndpointTypeEnum


class NodeGraph:
    """Part of `Node`."""

    def resolve_topic_name(self, topic: str, *, only_expand: bool = False) -> str:
        raise NotImplementedError

    def get_node_names(self) -> list[str]:
        return [node.get_name() for node in system().node_list]

    def get_fully_qualified_node_names(self) -> list[str]:
        return [node.get_fully_qualified_name() for node in system().node_list]

    def get_node_names_and_namespaces(self) -> list[tuple[str, str]]:
        return [(node.get_name(), node.get_namespace()) for node in system().node_list]

    def get_node_names_and_namespaces_with_enclaves(self) -> list[tuple[str, str, str]]:
        return [(name, namespace, "/") for name, namespace in self.get_node_names_and_namespaces()]

    def get_topic_names_and_types(self, no_demangle: bool = False) -> list[tuple[str, list[str]]]:
        graph = system().graph
        return _types([p for entries in (graph.publications, graph.subscriptions) for p in _all(entries)], "topic")

    def get_service_names_and_types(self) -> list[tuple[str, list[str]]]:
        return _types(_all(system().graph.servers), "name")

    def get_publisher_names_and_types_by_node(
        self, node_name: str, node_namespace: str, no_demangle: bool = False
    ) -> Any:
        return _types(_of(system().graph.publications, node_name, node_namespace), "topic")

    def get_subscriber_names_and_types_by_node(
        self, node_name: str, node_namespace: str, no_demangle: bool = False
    ) -> Any:
        return _types(_of(system().graph.subscriptions, node_name, node_namespace), "topic")

    def get_service_names_and_types_by_node(self, node_name: str, node_namespace: str) -> Any:
        return _types(_of(system().graph.servers, node_name, node_namespace), "name")

    def get_client_names_and_types_by_node(self, node_name: str, node_namespace: str) -> Any:
        return _types(_of(system().graph.clients, node_name, node_namespace), "name")

    def count_publishers(self, topic_name: str) -> int:
        return len(system().graph.publications.get(self.resolve_topic_name(topic_name), ()))

    def count_subscribers(self, topic_name: str) -> int:
        return len(system().graph.subscriptions.get(self.resolve_topic_name(topic_name), ()))

    def count_clients(self, service_name: str) -> int:
        return len(system().graph.clients.get(self.resolve_topic_name(service_name), ()))

    def count_services(self, service_name: str) -> int:
        return len(system().graph.servers.get(self.resolve_topic_name(service_name), ()))

    def get_publishers_info_by_topic(self, topic_name: str, no_mangle: bool = False) -> list[TopicEndpointInfo]:
        found = system().graph.publications.get(self.resolve_topic_name(topic_name), ())
        return [_info(entry, TopicEndpointTypeEnum.PUBLISHER) for entry in found]

    def get_subscriptions_info_by_topic(self, topic_name: str, no_mangle: bool = False) -> list[TopicEndpointInfo]:
        found = system().graph.subscriptions.get(self.resolve_topic_name(topic_name), ())
        return [_info(entry, TopicEndpointTypeEnum.SUBSCRIPTION) for entry in found]

    def wait_for_node(self, fully_qualified_node_name: str, timeout: float) -> bool:
        from .client import wait_until

        full = fully_qualified_node_name
        full = full if full.startswith("/") else f"/{full}"
        return wait_until(lambda: full in self.get_fully_qualified_node_names(), timeout, system().node_list[0].context)


def _all(table: dict[str, list[Any]]) -> list[Any]:
    return [entry for entries in table.values() for entry in entries]


def _of(table: dict[str, list[Any]], name: str, namespace: str) -> list[Any]:
    full = f"{namespace.rstrip('/')}/{name}"
    return [entry for entry in _all(table) if entry.node == full]


def _types(entries: list[Any], key: str) -> list[tuple[str, list[str]]]:
    found: dict[str, set[str]] = {}
    for entry in entries:
        found.setdefault(getattr(entry, key), set()).add(entry.type_name)
    return [(name, sorted(types)) for name, types in sorted(found.items())]


def _info(entry: Any, kind: TopicEndpointTypeEnum) -> TopicEndpointInfo:
    namespace, _, name = (entry.node or "/test").rpartition("/")
    quality = entry.quality
    profile = QoSProfile(
        history=HistoryPolicy.KEEP_ALL if quality.keep_all else HistoryPolicy.KEEP_LAST,
        depth=quality.depth,
        reliability=ReliabilityPolicy.RELIABLE if quality.reliable else ReliabilityPolicy.BEST_EFFORT,
        durability=DurabilityPolicy.TRANSIENT_LOCAL if quality.transient_local else DurabilityPolicy.VOLATILE,
    )
    return TopicEndpointInfo(name, namespace or "/", entry.type_name, None, kind, [0] * 16, profile)
