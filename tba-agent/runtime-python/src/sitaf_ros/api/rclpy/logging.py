"""Logging of rclpy."""

from __future__ import annotations

from typing import Any

from .impl.logging_severity import LoggingSeverity
from .impl.rcutils_logger import LogState, RcutilsLogger

__all__ = ["LoggingSeverity", "get_logger", "set_logger_level"]

_root = RcutilsLogger()


def get_logger(name: str) -> RcutilsLogger:
    if not name:
        raise ValueError("Logger name must not be empty.")
    return _root.get_child(name)


def initialize() -> None:
    """Logging is always ready."""


def shutdown() -> None:
    """Nothing needs to be closed."""


def clear_config() -> None:
    LogState.levels.clear()
    LogState.seen.clear()


def set_logger_level(name: str, level: int, detailed_error: bool = False) -> None:
    LogState.levels[name] = int(LoggingSeverity(level))


def get_logger_level(name: str) -> LoggingSeverity:
    return LoggingSeverity(LogState.levels.get(name, 0))


def get_logger_effective_level(name: str) -> LoggingSeverity:
    return RcutilsLogger(name).get_effective_level()


def get_logging_severity_from_string(log_severity: str) -> LoggingSeverity:
    try:
        return LoggingSeverity[log_severity.upper()]
    except KeyError as e:
        raise RuntimeError(f"'{log_severity}' is not a logging severity") from e


def get_logging_directory() -> Any:
    from pathlib import Path

    return Path("log")
