"""Names and types of actions."""

from __future__ import annotations

from typing import Any

from sitaf_ros.current import system

_SUFFIX = "/_action/send_goal"


def _actions(table: dict[str, list[Any]], node: str | None = None) -> list[tuple[str, list[str]]]:
    found: dict[str, set[str]] = {}
    for name, entries in table.items():
        for entry in entries:
            if name.endswith(_SUFFIX) and (node is None or entry.node == node):
                found.setdefault(name.removesuffix(_SUFFIX), set()).add(entry.type_name.removesuffix("_SendGoal"))
    return [(name, sorted(types)) for name, types in sorted(found.items())]


def get_action_client_names_and_types_by_node(node: Any, remote_node_name: str, remote_node_namespace: str) -> Any:
    return _actions(system().graph.clients, f"{remote_node_namespace.rstrip('/')}/{remote_node_name}")


def get_action_server_names_and_types_by_node(node: Any, remote_node_name: str, remote_node_namespace: str) -> Any:
    return _actions(system().graph.servers, f"{remote_node_namespace.rstrip('/')}/{remote_node_name}")


def get_action_names_and_types(node: Any) -> Any:
    graph = system().graph
    return _actions({**graph.clients, **graph.servers})
