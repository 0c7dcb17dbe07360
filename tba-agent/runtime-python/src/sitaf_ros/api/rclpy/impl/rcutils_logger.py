"""Loggers."""

from __future__ import annotations

import sys
from types import FrameType
from typing import Any

from sitaf_ros.current import CURRENT
from sitaf_ros.simulated_time import wall_ns

from .logging_severity import LoggingSeverity

_SUPPORTED = ("throttle_duration_sec", "throttle_time_source_type", "skip_first", "once")
_OWN_FILES = (__file__,)


class LogState:
    """Levels and call sites of this process."""

    levels: dict[str, int] = {}  # noqa: RUF012 -- one for all, by intention
    default = int(LoggingSeverity.INFO)
    seen: dict[tuple[str, int, int], float] = {}  # noqa: RUF012


class RcutilsLogger:
    def __init__(self, name: str = "") -> None:
        self.name = name

    def get_child(self, name: str) -> RcutilsLogger:
        if not name:
            raise ValueError("Need a valid name for the logger")
        return RcutilsLogger(f"{self.name}.{name}" if self.name else name)

    def set_level(self, level: int) -> None:
        LogState.levels[self.name] = int(LoggingSeverity(level))

    def get_effective_level(self) -> LoggingSeverity:
        name = self.name
        while name:
            level = LogState.levels.get(name, 0)
            if level:
                return LoggingSeverity(level)
            name = name.rpartition(".")[0]
        return LoggingSeverity(LogState.levels.get("", 0) or LogState.default)

    def is_enabled_for(self, severity: int) -> bool:
        return severity >= self.get_effective_level()

    def log(self, message: Any, severity: int, **kwargs: Any) -> bool:
        unknown = [key for key in kwargs if key not in _SUPPORTED and key != "name"]
        if unknown:
            raise TypeError(f"keyword argument '{unknown[0]}' is not a supported logging parameter")
        severity = LoggingSeverity(severity)
        if not self.is_enabled_for(severity) or not self._passes(kwargs):
            return False
        self._write(severity, str(message))
        return True

    @staticmethod
    def _passes(kwargs: dict[str, Any]) -> bool:
        throttle, once, skip = kwargs.get("throttle_duration_sec"), kwargs.get("once"), kwargs.get("skip_first")
        if throttle is None and not once and not skip:
            return True
        site, now = _call_site(), wall_ns() / 1e9
        last = LogState.seen.get(site)
        if once:
            LogState.seen[site] = now
            return last is None and not skip
        if skip and last is None:
            LogState.seen[site] = now if throttle is None else float("-inf")
            return False
        if throttle is not None:
            if last is not None and now - last < throttle:
                return False
            LogState.seen[site] = now
        return True

    def _write(self, severity: LoggingSeverity, text: str) -> None:
        system = CURRENT.system
        if system is not None and system.settings.log is not None:
            system.settings.log(severity.name, self.name, text, system.now_ns)
            return
        now = wall_ns()
        where = f"[{self.name}]: " if self.name else ""
        sys.stderr.write(f"[{severity.name}] [{now // 10**9}.{now % 10**9:09d}] {where}{text}\n")

    def debug(self, message: Any, **kwargs: Any) -> bool:
        return self.log(message, LoggingSeverity.DEBUG, **kwargs)

    def info(self, message: Any, **kwargs: Any) -> bool:
        return self.log(message, LoggingSeverity.INFO, **kwargs)

    def warning(self, message: Any, **kwargs: Any) -> bool:
        return self.log(message, LoggingSeverity.WARN, **kwargs)

    def warn(self, message: Any, **kwargs: Any) -> bool:
        return self.log(message, LoggingSeverity.WARN, **kwargs)

    def error(self, message: Any, **kwargs: Any) -> bool:
        return self.log(message, LoggingSeverity.ERROR, **kwargs)

    def fatal(self, message: Any, **kwargs: Any) -> bool:
        return self.log(message, LoggingSeverity.FATAL, **kwargs)


def _call_site() -> tuple[str, int, int]:
    frame: FrameType | None = sys._getframe()
    while frame is not None and frame.f_code.co_filename in _OWN_FILES:
        frame = frame.f_back
    # As in rclpy, two calls on one line are two places.
    return ("", 0, 0) if frame is None else (frame.f_code.co_filename, frame.f_lineno, frame.f_lasti)
