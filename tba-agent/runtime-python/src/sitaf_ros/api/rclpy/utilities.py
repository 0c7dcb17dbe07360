"""Helper functions of rclpy."""

from __future__ import annotations

import sys
from typing import Any

from sitaf_ros.current import CURRENT

from .constants import S_TO_NS

_NAMES = ("-r", "--remap", "-p", "--param", "--params-file", "--log-level", "-e", "--enclave", "--log-config-file")


class _Default:
    context: Any = None


def get_default_context(shutting_down: bool = False) -> Any:
    from .context import Context

    if _Default.context is None:
        _Default.context = Context()
    return _Default.context


def ok(*, context: Any = None) -> bool:
    threads = CURRENT.threads
    if threads is not None and threads.is_node_thread() and not threads.ending:
        threads.poll()
    return (get_default_context() if context is None else context).ok()


def shutdown(context: Any = None) -> None:
    (get_default_context() if context is None else context).shutdown()


def try_shutdown(context: Any = None) -> None:
    (get_default_context() if context is None else context).try_shutdown()


def remove_ros_args(args: list[str] | None = None) -> list[str]:
    """Return the arguments without what is between `--ros-args` and `--`."""
    kept: list[str] = []
    skipping = False
    for arg in sys.argv if args is None else args:
        if arg == "--ros-args":
            skipping = True
        elif skipping and arg == "--":
            skipping = False
        elif not skipping:
            kept.append(arg)
    return kept


def apply_ros_arguments(args: list[str]) -> None:
    """Apply remappings and parameters given after `--ros-args`."""
    system = CURRENT.system
    if system is None or "--ros-args" not in args:
        return
    from sitaf_ros.ros_arguments import apply

    apply(system, args)


def get_rmw_implementation_identifier() -> str:
    return "sitaf_ros"


def get_available_rmw_implementations() -> set[str]:
    return {"sitaf_ros"}


def timeout_sec_to_nsec(timeout_sec: float | None) -> int:
    if timeout_sec is None or timeout_sec < 0:
        return -1
    return int(timeout_sec * S_TO_NS)
