"""The process that loads the node and is forked for each case, so that module globals are fresh.

It is forked before the test driver opens files or connections, and the driver's process never loads code of the node.
"""

from __future__ import annotations

import os
import signal
import socket
import sys
import traceback
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import Any

from sitaf_runtime.errors import CannotRunError
from sitaf_runtime.ros import domain, sanitizer_report
from sitaf_runtime.ros.case_run import CallFailedError, CaseRun
from sitaf_runtime.ros.lines import Lines
from sitaf_runtime.ros.plan import Plan
from sitaf_runtime.suite import channel
from sitaf_runtime.thrown import describe

_INTERFACES = "sitaf_ros_interfaces"


class NodeProcess:
    """The driver's end of the process; raises CannotRunError when the node cannot be loaded."""

    def __init__(self, plan: Plan, folder: Path) -> None:
        ours, theirs = socket.socketpair()
        self._pid = os.fork()
        if self._pid == 0:
            ours.close()
            # Only the test driver writes results.
            channel.forget()
            if why := domain.enter():
                print(f"sitaf: the node's process can write results itself: {why}", file=sys.stderr, flush=True)
            _end_with(lambda: _serve(plan, folder, Lines(theirs)))
        theirs.close()
        self._lines = Lines(ours)
        self._in_case = False
        loaded = self._receive_or_end()
        if "problem" in loaded:
            raise CannotRunError(loaded["problem"])

    def begin(self, case: dict[str, Any]) -> None:
        """Begin a case."""
        self._in_case = True
        self._lines.send({"case": case})

    def answer(self, message: dict[str, Any]) -> None:
        """Answer what the case asked."""
        with suppress(OSError):  # its end is reported by `next`
            self._lines.send(message)

    def next(self) -> dict[str, Any]:
        """What the case asks for or has found; `ended` with the reason when its process has ended."""
        message = self._receive_or_end()
        if "ended" in message:
            self._in_case = False
        return message

    def abandon(self) -> None:
        """End a case that is still running."""
        if self._in_case:
            with suppress(OSError):
                self._lines.send({"abandon": True})
            while self._in_case:
                self.next()

    def close(self) -> None:
        """End the process."""
        with suppress(OSError):
            os.kill(self._pid, signal.SIGKILL)
        with suppress(OSError):
            os.waitpid(self._pid, 0)

    def _receive_or_end(self) -> dict[str, Any]:
        try:
            return self._lines.receive()
        except (EOFError, OSError):
            self._in_case = False
            cause = sanitizer_report.of(self._pid)
            ended = "the process that holds the node has ended"
            raise CannotRunError(f"{ended}: {cause}" if cause else ended) from None


class _AbandonedError(BaseException):
    """The test driver has ended the case; no error of the node."""


class _CaseLines(Lines):
    def receive(self) -> dict[str, Any]:
        message = super().receive()
        if "abandon" in message:
            raise _AbandonedError
        return message


def _serve(plan: Plan, folder: Path, lines: Lines) -> None:
    """Load the node, then run cases until the driver's process ends."""
    try:
        application = _load(plan, folder)
    except CannotRunError as e:
        lines.send({"problem": str(e)})
        return
    application.save_coverage()
    lines.send({"loaded": True})
    while True:
        try:
            case = lines.receive()
        except EOFError:
            return
        if "case" not in case:
            continue  # an order to end a case that has just ended
        if plan.suite_life:
            _run_in(application, plan, lines, case["case"])
            lines.send({"ended": ""})
            continue
        child = os.fork()
        if child == 0:
            _end_with(lambda case=case: _run_in(application, plan, lines, case["case"]))
        _, status = os.waitpid(child, 0)
        lines.send({"ended": sanitizer_report.of(child) or _reason(status, application)})


def _end_with(action: Callable[[], None]) -> None:
    """Do something, then end this process without what the parent's modules do at exit."""
    code = 0
    try:
        action()
    except BaseException:
        traceback.print_exc()
        code = 1
    finally:
        _save_coverage()
        for stream in (sys.stdout, sys.stderr):
            with suppress(OSError, ValueError, AttributeError):
                stream.flush()
        os._exit(code)


def _save_coverage() -> None:
    """Add what this process has recorded to the file that all processes of the node share."""
    coverage = sys.modules.get("coverage")
    current: Any = None if coverage is None else coverage.Coverage.current()
    if current is None:
        return
    with suppress(Exception):  # what a killed process would lose, too
        data = current._data
        folder, name = os.path.split(data.base_filename())
        own = os.path.join(folder, "node")
        os.makedirs(own, exist_ok=True)
        data._basename = os.path.join(own, name)
        data._reset()
        data._choose_filename()
        # Otherwise a forked process erases the file before it writes.
        data._pid, data._have_used = os.getpid(), True
        current.save()


def _reason(status: int, application: Any) -> str:
    if os.WIFSIGNALED(status):
        name, place = signal.Signals(os.WTERMSIG(status)).name, application.running()
        return f"the process of the node was ended by the signal {name}" + (f", in {place}" if place else "")
    code = os.waitstatus_to_exitcode(status)
    return f"the process of the node ended with exit code {code}" if code else ""


# What the set-up file of ROS sets; nodes ask for the release.
_OF_ROS = {"ROS_DISTRO": "jazzy", "ROS_VERSION": "2", "ROS_PYTHON_VERSION": "3"}


def _load(plan: Plan, folder: Path) -> Any:
    try:
        from sitaf_ros import RosApplication, RosLoadError, TypeFolders
    except ImportError as e:
        raise CannotRunError(f"the runtime of ROS 2 nodes is incomplete: {e}") from e
    package = plan.node["package"]
    sources = _sources(package)
    entry = plan.node["entry"]
    kind: Any = RosApplication
    if plan.node.get("installed"):
        from sitaf_ros.installed.application import InstalledApplication

        kind = InstalledApplication
        if plan.node.get("library"):
            from sitaf_ros.installed.cpp_application import InstalledCppApplication

            kind, entry = InstalledCppApplication, str(folder / plan.node["library"])
    elif plan.node.get("library"):
        from sitaf_ros.cpp.application import CppApplication

        kind, entry = CppApplication, str(folder / plan.node["library"])
    # Only what the node itself sees; the runtime's own modules keep their places.
    application = kind(
        TypeFolders([folder / _INTERFACES]), package=package, folders=[sources], share={package: sources}
    )
    try:
        application.load(entry, {**({} if plan.node.get("installed") else _OF_ROS), **plan.node["environment"]})
    except RosLoadError as e:
        raise CannotRunError(f"the node cannot be loaded: {e}") from e
    except BaseException as e:
        raise CannotRunError(f"the node cannot be loaded: {describe(e)}") from e
    return application


def _sources(package: str) -> Path:
    """The folder of package.xml on the module path."""
    for entry in sys.path:
        if entry and (Path(entry) / "package.xml").is_file():
            return Path(entry)
    raise CannotRunError(f"the sources of the package {package} are not on the module path")


def _run_in(application: Any, plan: Plan, lines: Lines, case: dict[str, Any]) -> None:
    application.run_case(lambda: _run(plan, application, lines, case), lambda: _end_with(lambda: None))


def _run(plan: Plan, application: Any, lines: Lines, case: dict[str, Any]) -> None:
    """Run a case and send its record."""
    own = _CaseLines.__new__(_CaseLines)
    own.__dict__.update(lines.__dict__)
    run = CaseRun(plan, application, own, case)
    record: dict[str, Any]
    try:
        try:
            record = run.run()
        except _AbandonedError:
            run.close()
            return
        except CallFailedError as e:
            record = {"error": str(e)}
        except Exception as e:
            record = {"error": _described(e)}
        run.close()
        record["notes"] = run.report()
    except Exception as e:
        record = {"error": _described(e)}
    application.save_coverage()
    lines.send({"record": record})


def _described(raised: Exception) -> str:
    """The text of an error of the node with the place in its sources."""
    cause = getattr(raised, "cause", None)
    if cause is None:
        return describe(raised) if not isinstance(raised, ValueError) else str(raised)
    # The innermost frame; the others are those of the library.
    place = describe(cause).partition(" at ")[2].partition(", ")[0]
    return str(raised) + (f" at {place}" if place else "")
