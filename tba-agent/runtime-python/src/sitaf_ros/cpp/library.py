"""The functions of a node's library, see `driver.cpp`."""

from __future__ import annotations

import ctypes
import os
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path


class _Event(ctypes.Structure):
    _fields_ = (
        ("kind", ctypes.c_int32),
        ("id", ctypes.c_int64),
        ("number", ctypes.c_int64),
        ("time", ctypes.c_int64),
        ("text", ctypes.c_void_p),
        ("text_size", ctypes.c_size_t),
        ("bytes", ctypes.c_void_p),
        ("bytes_size", ctypes.c_size_t),
    )


@dataclass(frozen=True, slots=True)
class Event:
    """What the node did."""

    kind: int
    id: int
    number: int
    time: int
    text: str
    bytes: bytes


class Library:
    """A loaded library."""

    def __init__(self, file: Path) -> None:
        self._lib = ctypes.CDLL(str(file), mode=os.RTLD_NOW | os.RTLD_LOCAL)
        i64, text, size = ctypes.c_int64, ctypes.c_char_p, ctypes.c_size_t
        for name, result, arguments in (
            ("set", None, (text, text, text)),
            ("begin", None, ()),
            ("run_ready", None, ()),
            ("next_deadline", i64, ()),
            ("set_now", None, (i64,)),
            ("advance", None, (i64,)),
            ("end", None, ()),
            ("take", ctypes.c_int, (ctypes.POINTER(_Event),)),
            ("overrides", None, (text, size)),
            ("number", i64, ()),
            ("advertise", i64, (text, text)),
            ("publish", None, (i64, text, size)),
            ("subscribe", i64, (text, text)),
            ("serve", i64, (text, text)),
            ("respond", None, (i64, text, size)),
            ("call", i64, (text, text, text, size)),
            ("failure", text, ()),
            ("running", text, ()),
            ("offers", ctypes.c_int, (text,)),
            ("report", text, ()),
            ("nodes", text, ()),
        ):
            function = getattr(self._lib, f"sitaf_ros_{name}")
            function.restype = result
            function.argtypes = arguments
        self.begin = self._lib.sitaf_ros_begin
        self.run_ready = self._lib.sitaf_ros_run_ready
        self.next_deadline = self._lib.sitaf_ros_next_deadline
        self.set_now = self._lib.sitaf_ros_set_now
        self.advance = self._lib.sitaf_ros_advance
        self.end = self._lib.sitaf_ros_end
        self.number = self._lib.sitaf_ros_number

    def set(self, what: str, name: str, value: str) -> None:
        """Set something for the case."""
        self._lib.sitaf_ros_set(what.encode(), name.encode(), value.encode())

    def events(self) -> Iterator[Event]:
        """Take what the node did."""
        raw = _Event()
        while self._lib.sitaf_ros_take(ctypes.byref(raw)):
            text = ctypes.string_at(raw.text, raw.text_size).decode(errors="replace")
            data = ctypes.string_at(raw.bytes, raw.bytes_size) if raw.bytes_size else b""
            yield Event(raw.kind, raw.id, raw.number, raw.time, text, data)

    def overrides(self, data: bytes) -> None:
        """Give the overrides that a node asked for."""
        self._lib.sitaf_ros_overrides(data, len(data))

    def advertise(self, topic: str, type_name: str) -> int:
        """Make the test a publisher."""
        return self._lib.sitaf_ros_advertise(topic.encode(), type_name.encode())

    def publish(self, publication: int, data: bytes) -> None:
        """Publish a serialized message."""
        self._lib.sitaf_ros_publish(publication, data, len(data))

    def subscribe(self, topic: str, type_name: str) -> int:
        """Make the test a subscription."""
        return self._lib.sitaf_ros_subscribe(topic.encode(), type_name.encode())

    def serve(self, name: str, type_name: str) -> int:
        """Make the test a service."""
        return self._lib.sitaf_ros_serve(name.encode(), type_name.encode())

    def respond(self, number: int, data: bytes) -> None:
        """Answer a request."""
        self._lib.sitaf_ros_respond(number, data, len(data))

    def call(self, name: str, type_name: str, data: bytes) -> int:
        """Call a service; 0 if nobody offers it."""
        return self._lib.sitaf_ros_call(name.encode(), type_name.encode(), data, len(data))

    def failure(self) -> str:
        """Return the first failure of the node."""
        return self._lib.sitaf_ros_failure().decode(errors="replace")

    def running(self) -> str:
        """Return what the node does, or did in the last forked process: its memory is shared."""
        return self._lib.sitaf_ros_running().decode(errors="replace")

    def offers(self, name: str) -> bool:
        """Tell whether a node offers a service."""
        return bool(self._lib.sitaf_ros_offers(name.encode()))

    def save_coverage(self) -> None:
        """Add what this process has executed to the files of gcov, and start again at zero."""
        save_coverage(self._lib)

    def report(self) -> list[str]:
        """Return what nothing looked at."""
        return self._lib.sitaf_ros_report().decode(errors="replace").splitlines()

    def nodes(self) -> list[str]:
        """Return the full names of the nodes."""
        return self._lib.sitaf_ros_nodes().decode(errors="replace").splitlines()


def save_coverage(library: ctypes.CDLL) -> None:
    """Add what this process has executed of a node to the files of gcov, and start again at zero.

    Nothing happens if the node was not compiled to count.
    """
    for name in ("__gcov_dump", "__gcov_reset"):
        if function := getattr(library, name, None):
            function()
