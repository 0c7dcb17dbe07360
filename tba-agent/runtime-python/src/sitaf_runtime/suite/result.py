"""Records of cases and the file that they go to."""

import enum
import os
import re
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from sitaf_runtime.ports import PortChanges
from sitaf_runtime.suite import channel, literals
from sitaf_runtime.suite.calls import StubCall
from sitaf_runtime.suite.kinds import Kind
from sitaf_runtime.suite.test_case import TestCase, TestStep

# In characters; messages of a component's exceptions may have any length.
_MAX_MESSAGE_LENGTH = 8000
_MOST_NOTES = 100
# In characters, of a value in the text about a difference.
_MAX_DIFFERENCE = 200

# Maximum number of results that a power failure loses; a killed process loses none.
_LINES_TO_SYNC = 4096


class Outcome(enum.Enum):
    """How a case ended. The agent, which knows the expected values, decides the verdict later.

    RETURNED: the call returned; its outputs are recorded. THREW: the call under test raised an exception. ERROR:
    anything else failed, such as creation, set-up, a tick or a limit. NOT_CALLED: the component was not called.
    """

    RETURNED = enum.auto()
    THREW = enum.auto()
    ERROR = enum.auto()
    NOT_CALLED = enum.auto()


class CaseResult:
    """The record of a case or of a step.

    The test driver fills it in and saves it. It contains neither expected values nor verdicts, which the agent adds.
    """

    __slots__ = (
        "_actual",
        "_at_ns",
        "_calls",
        "_calls_left_out",
        "_case",
        "_differs",
        "_message",
        "_notes",
        "_outcome",
        "_ports",
        "_repeated_ns",
        "_thrown",
        "_time",
    )

    def __init__(self, test_case: TestCase) -> None:
        self._case = test_case
        self._actual: dict[str, str] = {}
        self._time: tuple[float, float, float] | None = None
        self._calls: Sequence[StubCall] = ()
        self._calls_left_out = 0
        self._outcome = Outcome.RETURNED
        self._thrown = ""
        self._message = ""
        self._notes: list[str] = []
        self._repeated_ns: list[int] | None = None
        self._differs = ""
        self._at_ns = 0
        self._ports: Sequence[PortChanges] = ()

    def began_at(self, at_ns: int) -> None:
        """Set when a step began: simulation time in nanoseconds since the first step of the case."""
        self._at_ns = at_ns

    def set_time(self, component: float, hardware: float, stub: float) -> None:
        """Set the processing time in microseconds; `component` excludes the other two."""
        self._time = (component, hardware, stub)

    def set_calls(self, calls: Sequence[StubCall], left_out: int) -> None:
        """Set the calls of the component to its required interfaces, and how many further calls were not recorded."""
        self._calls = calls
        self._calls_left_out = left_out

    def set_ports(self, ports: Sequence[PortChanges]) -> None:
        """Set the values of the output data ports during the case."""
        self._ports = ports

    def record(self, output: str, value: Any, kind: Kind[Any]) -> None:
        """Record the value of an output."""
        self._actual[output] = literals.write(kind.shaped(value))

    def record_literal(self, output: str, literal: str) -> None:
        """Record the literal of an output."""
        self._actual[output] = literal

    def note(self, text: str) -> None:
        """Note something that the component did and the test does not look at."""
        self._notes.append(text)

    def record_return(self, output: str) -> None:
        """Record that a method without a return value returned."""
        self._actual[output] = literals.write(None)

    def threw(self, raised: BaseException, description: str) -> None:
        """End the case with an exception of the call under test."""
        self._thrown = type(raised).__name__
        self.end_with(Outcome.THREW, description)

    def end_with(self, outcome: Outcome, reason: str) -> None:
        """Set the outcome of a case that did not return; the reason is appended to the message."""
        self._outcome = outcome
        self._message = f"{self._message}; {reason}" if self._message else reason

    def stopped(self, reason: str) -> None:
        """End a step that was stopped before its end; how it reacted to that does not count."""
        self._thrown = self._message = ""
        self.end_with(Outcome.ERROR, reason)

    @property
    def is_repeatable(self) -> bool:
        """Whether the component was called and nothing else failed."""
        return self._outcome in (Outcome.RETURNED, Outcome.THREW)

    def begin_repeated(self) -> None:
        """From now on, repeated calls of the case are added."""
        self._repeated_ns = []

    def add_repeated(self, again: "CaseResult", number: int, *, measured: bool) -> None:
        """Add the record of a repeated call.

        `number` is that of the call, from 2. The time of a call that is not `measured` does not count.
        """
        if not self._differs:
            difference = again._difference(self)
            if difference:
                self._differs = f"call {number}: {difference}"
        if measured and again._time is not None and again._outcome is self._outcome and self._repeated_ns is not None:
            self._repeated_ns.append(round(again._time[0] * 1000))

    def _difference(self, first: "CaseResult") -> str:
        """What this record gives instead of the first one; empty if they give the same."""
        if self._outcome is not first._outcome or self._thrown != first._thrown:
            return f"{self._ending()}, but the first call {first._ending()}"
        for name, literal in self._actual.items():
            before = first._actual.get(name, "null")
            if literal != before:
                return f"{name} is {_cut(literal)}, not {_cut(before)}"
        return ""

    def _ending(self) -> str:
        if self._outcome is Outcome.RETURNED:
            return "returned"
        if self._outcome is Outcome.THREW:
            return f"threw {_cut(self._thrown)}"
        return f"failed: {_cut(self._message)}"

    def line(self) -> bytes:
        """The record as one line of XML (docs/test-application.md, The record of a case), ending with a line feed."""
        case = self._case
        if isinstance(case, TestStep):
            root = "step_record"
            step = f' step="{case.number}" name="{_escaped(case.name)}"'
            at = f' at_ns="{self._at_ns}"'
        else:
            root, step, at = "case_record", "", ""
        parts = [f'<{root} no="{case.no}"{step} outcome="{self._outcome.name}"{at}>']
        if self._outcome is Outcome.THREW:
            parts.append(f"<thrown>{_escaped(self._thrown)}</thrown>")
        parts += [_value("actual", name, literal) for name, literal in self._actual.items()]
        parts += [_call(call) for call in self._calls]
        if self._calls_left_out:
            parts.append(f"<calls_left_out>{self._calls_left_out}</calls_left_out>")
        parts += [_port(port) for port in self._ports]
        if self._time is not None:
            component, hardware, stub = self._time
            parts.append(
                f'<processing_time unit="us" hardware="{hardware:.3f}" stub="{stub:.3f}">'
                f"{component:.3f}</processing_time>"
            )
        if self._repeated_ns is not None:
            parts.append(f"<repeated_calls>{' '.join(map(str, self._repeated_ns))}</repeated_calls>")
            if self._differs:
                parts.append(f"<differs>{_escaped(self._differs)}</differs>")
        if self._message:
            parts.append(f"<message>{_escaped(_shortened(self._message))}</message>")
        parts += [f"<note>{_escaped(_shortened(note))}</note>" for note in self._notes[:_MOST_NOTES]]
        parts.append(f"</{root}>\n")
        return "".join(parts).encode()


class ResultsFile:
    """The results of a run: one line per case, written in one call, so that a killed process loses none.

    When the output is a descriptor of the agent, each line starts with its number and a token.
    """

    def __init__(self, file: Path, *, append: bool) -> None:
        """Open a file and truncate it, or append to it; an incomplete last line is terminated first.

        `fd:3` names an open descriptor. Raises CannotRunError when it is not open.
        """
        self._number = 0
        self._token = b""
        if channel.is_named(file):
            self._descriptor, token = channel.take(file)
            self._token = token.encode()
            return
        flags = os.O_CREAT | os.O_RDWR | os.O_CLOEXEC | (0 if append else os.O_TRUNC)
        self._descriptor = os.open(file, flags, 0o644)
        self._unsynced = 0
        end = os.lseek(self._descriptor, 0, os.SEEK_END)
        if end and os.pread(self._descriptor, 1, end - 1) != b"\n":
            os.write(self._descriptor, b"\n")

    def ready(self) -> None:
        """Write an empty line, which reports that set-up is complete; then the time limit of cases applies."""
        self._write(b"\n")

    def save(self, result: CaseResult) -> None:
        """Write the line of a case."""
        self._write(result.line())
        if self._token:
            return
        self._unsynced += 1
        if self._unsynced >= _LINES_TO_SYNC:
            self._unsynced = 0
            os.fsync(self._descriptor)

    def close(self) -> None:
        """Sync a file to the disk and close it."""
        if not self._token:
            os.fsync(self._descriptor)
        os.close(self._descriptor)

    def _write(self, line: bytes) -> None:
        if self._token:
            self._number += 1
            line = b"%d %b %b" % (self._number, self._token, line)
        while line:
            line = line[os.write(self._descriptor, line) :]


# Characters that XML cannot contain or does not preserve, and the line separators of Unicode.
_SPECIAL = re.compile("[^ !#-%'-;=?-~\xa0-\u2027\u202a-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
_NAMED = {"&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;"}
_REFERENCED = "\n\r\t\x85\u2028\u2029"
_XML = re.compile("[\x7f-\x9f]")


def _escaped(text: str) -> str:
    return _SPECIAL.sub(_escape, text) if _SPECIAL.search(text) else text


def _escape(match: re.Match[str]) -> str:
    c = match.group()
    if c in _NAMED:
        return _NAMED[c]
    if c in _REFERENCED:
        return f"&#{ord(c)};"
    return c if _XML.match(c) else f"\\u{ord(c):04X}"


def _value(element: str, name: str, literal: str) -> str:
    return f'<{element} name="{_escaped(name)}">{_escaped(literal)}</{element}>'


def _call(call: StubCall) -> str:
    arguments = "".join(_value("argument", name, literal) for name, literal in call.arguments.items())
    return f'<call method="{_escaped(call.method)}">{arguments}</call>'


def _port(port: PortChanges) -> str:
    changes = "".join(f'<at ns="{at}">{_escaped(literal)}</at>' for at, literal in port.changes)
    return f'<port name="{_escaped(port.signal)}" left_out="{port.left_out}">{changes}</port>'


def _cut(text: str) -> str:
    return text if len(text) <= _MAX_DIFFERENCE else f"{text[:_MAX_DIFFERENCE]}..."


def _shortened(text: str) -> str:
    if len(text) <= _MAX_MESSAGE_LENGTH:
        return text
    return f"{text[:_MAX_MESSAGE_LENGTH]} ... ({len(text)} characters)"
