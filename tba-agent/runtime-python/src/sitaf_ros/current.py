"""The case that runs in this process, and the types of its activity; the API packages find them here."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from sitaf_ros.application import RosApplication
    from sitaf_ros.messages import MessageClasses
    from sitaf_ros.node_threads import NodeThreads
    from sitaf_ros.system import RosSystem


class _Current:
    application: RosApplication | None = None
    system: RosSystem | None = None
    threads: NodeThreads | None = None
    loading_thread: int | None = None


CURRENT = _Current()


def application() -> RosApplication:
    """Return the loaded application."""
    if CURRENT.application is None:
        raise RuntimeError("no ROS application is loaded in this process")
    return CURRENT.application


def classes() -> MessageClasses:
    """Return the message classes of the application."""
    return application().classes


def message(name: str) -> Any:
    """Return the class of a full type name."""
    return application().classes.message(name)


def system() -> RosSystem:
    """Return the running case."""
    if CURRENT.system is None:
        raise RuntimeError("a ROS node can run only in a test case: rclpy was used while the module was imported")
    return CURRENT.system


def note_later_release(what: str) -> None:
    """Note that a node uses what Jazzy does not have, which runs here nevertheless."""
    system().unobserved.warn(f"{what}: in ROS 2 from Kilted on, an error in Jazzy")


def node_threads() -> NodeThreads | None:
    """Return the threads of the case if the caller is one of them, else None."""
    threads = CURRENT.threads
    return threads if threads is not None and threads.is_node_thread() else None


def is_simulated() -> bool:
    """Tell whether the caller is a node thread, or a node's module while it is imported."""
    return node_threads() is not None or CURRENT.loading_thread == threading.get_ident()
