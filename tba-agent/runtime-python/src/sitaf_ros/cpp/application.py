"""A compiled C++ node in the place of a Python node: the same test application drives both."""

from __future__ import annotations

import ctypes
import os
import sys
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import Any, ClassVar

from sitaf_ros import RosApplication, conversion, serialization
from sitaf_ros.cpp.library import Library
from sitaf_ros.cpp.shims import CppGraph, CppThreads
from sitaf_ros.current import CURRENT
from sitaf_ros.definitions import MessageTypes
from sitaf_ros.errors import NodeError, RosLoadError
from sitaf_ros.names import Remapping
from sitaf_ros.settings import Overrides, RosSettings
from sitaf_ros.system import RosSystem
from sitaf_ros.test_side import full
from sitaf_ros.unobserved import RosReport

_LEVELS = {10: "DEBUG", 20: "INFO", 30: "WARN", 40: "ERROR", 50: "FATAL"}
# The event of a node that asks for its overrides.
_OVERRIDES = 4
# rcl_interfaces/msg/ParameterType
_BOOL, _INTEGER, _DOUBLE, _STRING = 1, 2, 3, 4
_BOOLS, _INTEGERS, _DOUBLES, _STRINGS = 6, 7, 8, 9


class CppApplication(RosApplication):
    """A library that `sitaf_ros.cpp.build` made."""

    def __init__(
        self,
        types: MessageTypes,
        package: str = "",
        folders: Iterable[Path] = (),
        share: Mapping[str, Path] | None = None,
    ) -> None:
        super().__init__(types, package, folders, share)
        self._library: Library | None = None

    def install(self) -> None:
        """Make the classes of messages known; nothing of Python is simulated."""
        CURRENT.application = self

    def load(self, entry: str, environment: Mapping[str, str] | None = None, arguments: Iterable[str] = ()) -> None:
        """Load the library, the file `entry`; its static variables are made now."""
        del arguments
        self.install()
        os.environ.update(environment or {})
        for name, folder in self.share.items():
            os.environ[f"SITAF_SHARE_{name}"] = str(folder)
        try:
            self._library = Library(Path(entry))
            self._library.running()  # makes the memory that forked processes share
        except OSError as e:
            raise RosLoadError([f"the library of the node cannot be loaded: {e}"]) from e

    def running(self) -> str:
        """Return what the node did when the last forked process ended."""
        return "" if self._library is None else self._library.running()

    def save_coverage(self) -> None:
        """Save which lines of the node this process has executed, if they are counted."""
        if self._library is not None:
            self._library.save_coverage()

    def start(self, settings: RosSettings) -> RosSystem:
        """Begin a case in this process; its nodes are made in the first `run_until`."""
        if self._library is None:
            raise RuntimeError("call `load` before `start`")
        os.environ.update(settings.environment)
        return CppSystem(self, settings, self._library)


class CppSystem(RosSystem):
    """The nodes of a case, which are in the library."""

    def __init__(self, application: CppApplication, settings: RosSettings, library: Library) -> None:
        super().__init__(application, settings)
        self._library = library
        self.remapping = Remapping({})
        self.overrides = Overrides(settings)
        self.threads: Any = CppThreads(library, self._take_events)
        self.graph: Any = CppGraph(library, application.classes)
        for line in settings.stdin:
            library.set("stdin", "", line)
        for source, target in settings.remap.items():
            library.set("remap", source, target)
        library.set("callback_order", "", str(settings.callback_order))
        library.set("use_sim_time", "", "1" if settings.use_sim_time else "0")
        library.begin()

    def _take_events(self) -> bool:
        """Take what the nodes did; return whether a node may go on."""
        goes_on = False
        for event in self._library.events():
            self._events[event.kind](self, event)
            goes_on = goes_on or event.kind == _OVERRIDES
        failure = self._library.failure()
        if failure and self._failure is None:
            where, _, what = failure.partition("\t")
            self._failure = CppNodeError(where, what)
        return goes_on

    def _message(self, event: Any) -> None:
        entry = self.graph.test_subscriptions[event.id]
        message = self.graph.read(entry.type_name, event.bytes)
        self._for_test.append(lambda: entry.callback(message, event.time))

    def _request(self, event: Any) -> None:
        self.graph.asked(event)

    def _response(self, event: Any) -> None:
        self.graph.answered(event)

    def _overrides(self, event: Any) -> None:
        name, _, namespace = event.text.partition("\n")
        found = self.overrides.of(name, namespace)
        found.pop("use_sim_time", None)
        parameters = [{"name": n, "value": _parameter(v)} for n, v in found.items()]
        message = conversion.from_fields(
            self.application.classes, "rcl_interfaces/msg/ParameterEvent", {"new_parameters": parameters}
        )
        self._library.overrides(serialization.serialize(message))

    def _log(self, event: Any) -> None:
        logger, _, text = event.text.partition("\n")
        level = _LEVELS.get(event.number, "INFO")
        if self.settings.log is not None:
            self.settings.log(level, logger, text, event.time)
        else:
            time = (event.time + (0 if self.settings.use_sim_time else 1_700_000_000 * 10**9)) / 1e9
            sys.stderr.write(f"[{level}] [{time:.9f}] [{logger}]: {text}\n")

    _events: ClassVar[dict[int, Callable[[CppSystem, Any], None]]] = {
        1: _message,
        2: _request,
        3: _response,
        4: _overrides,
        5: _log,
    }

    def subscribe(self, topic: str, type_name: str, callback: Callable[[Any, int], None]) -> None:
        """Call back in the driver's thread with each message and its time of publication in ns."""
        self.application.classes.message(type_name)
        self.graph.subscribe(full(topic), type_name, callback)

    def service_ready(self, name: str) -> bool:
        """Tell whether a node offers a service."""
        return self._library.offers(full(name))

    def nodes(self) -> list[Any]:
        """Return the full names of the nodes."""
        return self._library.nodes()

    def end(self) -> None:
        """End the case: spin returns, what follows runs, but publishes nothing."""
        self._library.end()
        self._take_events()
        ctypes.CDLL(None).fflush(None)

    def report(self) -> RosReport:
        """Return what the nodes did that nothing looked at."""
        found: dict[str, list[str]] = {}
        for line in self._library.report():
            kind, _, name = line.partition("\t")
            found.setdefault(kind, []).append(name)
        found.setdefault("warnings", []).extend(self.unobserved.warnings())
        return RosReport(**{kind: tuple(sorted(names)) for kind, names in found.items()})


class CppNodeError(NodeError):
    """An exception that a C++ node threw."""

    def __init__(self, where: str, what: str) -> None:
        Exception.__init__(self, f"{what} (in {where})")
        self.where, self.cause = where, None


def _parameter(value: Any) -> dict[str, Any]:
    """A value as rcl_interfaces/msg/ParameterValue."""
    if isinstance(value, bool):
        return {"type": _BOOL, "bool_value": value}
    if isinstance(value, int):
        return {"type": _INTEGER, "integer_value": value}
    if isinstance(value, float):
        return {"type": _DOUBLE, "double_value": value}
    if isinstance(value, list | tuple):
        listed = list(value)
        if listed and all(isinstance(item, bool) for item in listed):
            return {"type": _BOOLS, "bool_array_value": listed}
        if listed and all(isinstance(item, int) for item in listed):
            return {"type": _INTEGERS, "integer_array_value": listed}
        if listed and all(isinstance(item, int | float) for item in listed):
            return {"type": _DOUBLES, "double_array_value": [float(item) for item in listed]}
        return {"type": _STRINGS, "string_array_value": [str(item) for item in listed]}
    return {"type": _STRING, "string_value": str(value)}
