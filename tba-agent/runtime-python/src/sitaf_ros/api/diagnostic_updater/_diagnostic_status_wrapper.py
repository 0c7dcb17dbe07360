"""A status that tasks fill."""

from __future__ import annotations

from typing import Any

from sitaf_ros.current import message

OK, WARN, ERROR, STALE = b"\0", b"\1", b"\2", b"\3"
_Status: Any = message("diagnostic_msgs/msg/DiagnosticStatus")


class DiagnosticStatusWrapper(_Status):
    def __init__(self, *args: Any, **kwargs: Any) -> None:
        super().__init__(*args, **kwargs)
        if not self.message:
            self.message = ""

    def summary(self, *args: Any) -> None:
        if len(args) == 1:
            self.level, self.message = args[0].level, args[0].message
        else:
            self.level, self.message = _level(args[0]), str(args[1])

    def clearSummary(self) -> None:
        self.summary(OK, "")

    clear_summary = clearSummary

    def mergeSummary(self, *args: Any) -> None:
        level, text = (args[0].level, args[0].message) if len(args) == 1 else (_level(args[0]), str(args[1]))
        if (self.level > OK) == (level > OK):
            self.message = f"{self.message}; {text}" if self.message else text
        elif level > self.level:
            self.message = text
        self.level = max(self.level, level)

    merge_summary = mergeSummary

    def summaryf(self, level: Any, form: str, *args: Any) -> None:
        self.summary(level, form % args)

    def mergeSummaryf(self, level: Any, form: str, *args: Any) -> None:
        self.mergeSummary(level, form % args)

    def add(self, key: str, val: Any) -> None:
        values = [*self.values, message("diagnostic_msgs/msg/KeyValue")(key=key, value=str(val))]
        self.values = values

    def addf(self, key: str, form: str, *args: Any) -> None:
        self.add(key, form % args)


def _level(level: Any) -> bytes:
    return bytes([level]) if isinstance(level, int) else level
