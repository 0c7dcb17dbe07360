"""The API of rclpy (Jazzy) over simulated time; see https://docs.ros.org/en/jazzy/p/rclpy/ for its meaning."""

from __future__ import annotations

from typing import Any

from sitaf_ros.current import note_later_release

from . import (
    callback_groups,
    clock,
    context,
    duration,
    exceptions,
    executors,
    logging,
    node,
    parameter,
    qos,
    signals,
    task,
    time,
    timer,
    utilities,
)
from .context import Context
from .executors import Executor, SingleThreadedExecutor
from .node import Node
from .parameter import Parameter
from .signals import SignalHandlerOptions
from .task import Future, Task
from .utilities import get_rmw_implementation_identifier, ok, shutdown, try_shutdown

__all__ = [
    "Context",
    "Executor",
    "Future",
    "Node",
    "Parameter",
    "SignalHandlerOptions",
    "Task",
    "callback_groups",
    "clock",
    "context",
    "create_node",
    "duration",
    "exceptions",
    "executors",
    "get_default_context",
    "get_global_executor",
    "get_rmw_implementation_identifier",
    "init",
    "logging",
    "node",
    "ok",
    "parameter",
    "qos",
    "shutdown",
    "signals",
    "spin",
    "spin_once",
    "spin_until_future_complete",
    "task",
    "time",
    "timer",
    "try_shutdown",
    "utilities",
]

get_default_context = utilities.get_default_context


class _Global:
    executor: Executor | None = None


class InitContextManager:
    """What `init` returns: shuts down at the end of a `with` block."""

    def __init__(self, used: Context) -> None:
        self.context = used

    def __enter__(self) -> InitContextManager:
        note_later_release("with rclpy.init()")
        return self

    def __exit__(self, *_: object) -> None:
        if self.context is get_default_context():
            _close_global_executor()
        self.context.try_shutdown()


def init(
    *,
    args: list[str] | None = None,
    context: Context | None = None,
    domain_id: int | None = None,
    signal_handler_options: SignalHandlerOptions | None = None,
) -> InitContextManager:
    used = get_default_context() if context is None else context
    used.init(args, domain_id=domain_id)
    return InitContextManager(used)


def _close_global_executor() -> None:
    if _Global.executor is not None:
        _Global.executor.shutdown()
        _Global.executor = None


def get_global_executor() -> Executor:
    if _Global.executor is None or _Global.executor._is_shutdown:
        _Global.executor = SingleThreadedExecutor()
    return _Global.executor


def create_node(node_name: str, **kwargs: Any) -> Node:
    return Node(node_name, **kwargs)


def spin(node: Node, executor: Executor | None = None) -> None:
    used = get_global_executor() if executor is None else executor
    try:
        used.add_node(node)
        used.spin()
    finally:
        used.remove_node(node)


def spin_once(node: Node, *, executor: Executor | None = None, timeout_sec: float | None = None) -> None:
    used = _for_nested(node, executor)
    added = used.add_node(node)
    try:
        used.spin_once(timeout_sec=timeout_sec)
    finally:
        if added:
            used.remove_node(node)


def spin_until_future_complete(
    node: Node,
    future: Future,
    executor: Executor | None = None,
    timeout_sec: float | None = None,
) -> None:
    used = _for_nested(node, executor)
    added = used.add_node(node)
    try:
        used.spin_until_future_complete(future, timeout_sec)
    finally:
        if added:
            used.remove_node(node)


def _for_nested(node: Node, executor: Executor | None) -> Executor:
    """A nested spin uses the node's executor, so that the outer one keeps the node."""
    if executor is not None:
        return executor
    current = node.executor
    nested = current is not None and not current._is_shutdown and node in current.get_nodes()
    return current if nested and current is not None else get_global_executor()
