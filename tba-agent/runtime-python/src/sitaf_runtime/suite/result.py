"""Results of cases and the file that they go to."""

import enum
import os
import re
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from sitaf_runtime.errors import CaseDataError
from sitaf_runtime.suite import channel, literals
from sitaf_runtime.suite.calls import StubCall
from sitaf_runtime.suite.comparison import difference
from sitaf_runtime.suite.kinds import Kind
from sitaf_runtime.suite.test_case import TestCase
from sitaf_runtime.suite.tolerance import Tolerance

# What a component puts into an exception has no bound of its own.
_MAX_MESSAGE_LENGTH = 8000
_ERROR = "!error:"
# Begins an expected value that could not be worked out.
_UNEVALUATED = "!unevaluated:"

# How many results a machine may lose with its power; a process that is killed loses none.
_LINES_TO_SYNC = 4096


class Verdict(enum.IntEnum):
    """How a case ended; the worse is the greater."""

    PASS = 0
    FAIL = 1
    ERROR = 2
    DONT = 3


class CaseResult:
    """What becomes of one case; the test driver fills it in and saves it."""

    __slots__ = ("_actual", "_calls", "_case", "_compared", "_left_out", "_message", "_time", "verdict")

    def __init__(self, test_case: TestCase) -> None:
        self._case = test_case
        self._actual: dict[str, str] = {}
        self._compared: set[str] = set()
        self._time: tuple[float, float, float] | None = None
        self._calls: Sequence[StubCall] = ()
        self._left_out = 0
        self._message = ""
        self.verdict = Verdict.PASS

    def took(self, component: float, hardware: float, stub: float) -> None:
        """Keep how long the call took; all in microseconds, the first without the other two."""
        self._time = (component, hardware, stub)

    def called(self, calls: Sequence[StubCall], left_out: int) -> None:
        """Keep what the stub was called with, and how many calls more there were."""
        self._calls = calls
        self._left_out = left_out

    def raised(self, error: BaseException) -> bool:
        """Compare what the call raised with `!error:NAME`; whether it is what an output was expected to be."""
        spelled = _ERROR + type(error).__name__
        outputs = [output for output, literal in self._case.expected.items() if literal.strip() == spelled]
        if not outputs or not isinstance(error, Exception):
            return False
        self._compared.update(self._case.expected)
        self._actual[outputs[0] or "return"] = spelled
        return True

    def record(self, output: str, value: Any, kind: Kind[Any]) -> None:
        """Keep an output that nothing is expected of."""
        self._actual[output] = literals.spell(kind.shaped(value))

    def compare(self, output: str, value: Any, kind: Kind[Any], tolerance: Tolerance) -> None:
        """Keep an output, and compare it where the case expects something of it."""
        value = kind.shaped(value)
        self._actual[output] = literals.spell(value)
        expected = self._case.expectation(output)
        if expected is None:
            return
        if self._is_no_value(output, expected, " " + self._actual[output]):
            return
        try:
            apart = difference(expected, value, tolerance)
        except CaseDataError as e:
            self._worsen(Verdict.ERROR, self._named(output, f"what is expected cannot be compared with it: {e}"))
            return
        if apart:
            inside = apart.startswith((".", "["))
            self._worsen(Verdict.FAIL, output + apart if inside else self._named(output, apart))

    def returned_nothing(self, output: str) -> None:
        """Keep that a method returned which returns nothing.

        A case can expect that, `null`, or an error.
        """
        self._actual[output] = literals.spell(None)
        expected = self._case.expectation(output)
        if expected is None or self._is_no_value(output, expected, ""):
            return
        if expected.strip() != literals.spell(None):
            self._worsen(
                Verdict.ERROR,
                f"nothing is returned, so that {expected} cannot be expected, but null or an error such as !error:NAME",
            )

    def _is_no_value(self, output: str, expected: str, returned: str) -> bool:
        """Judge an output of which no value is expected, but an error, or that is not known."""
        self._compared.add(output if output in self._case.expected else "")
        if expected.startswith(_UNEVALUATED):
            self._worsen(Verdict.ERROR, f"what is expected has no value:{expected.removeprefix(_UNEVALUATED)}")
            return True
        if expected.startswith(_ERROR):
            error = expected.removeprefix(_ERROR)
            self._worsen(Verdict.FAIL, f"expected the error {error}, but it returned{returned}")
            return True
        return False

    def ended_with(self, verdict: Verdict, reason: str) -> None:
        """The case did not get as far as a comparison, or not through it."""
        self._worsen(verdict, reason)

    def line(self) -> bytes:
        """The result as one line of XML (paper, Fig. 11), line feed included.

        An expected value that no output was compared with makes an ERROR of a case that would pass unseen.
        """
        if self.verdict == Verdict.PASS:
            for output in self._case.expected:
                if output not in self._compared:
                    self._worsen(
                        Verdict.ERROR,
                        f"the suite expects a value of '{output}', which the test application does not know",
                    )
        named = len(self._actual) > 1
        parts = [f'<test_result no="{self._case.no}" verdict="{self.verdict.name}">']
        parts += [f"<value>{_escaped(literal)}</value>" for literal in self._case.values.values()]
        parts += [_output("expected", name, literal) for name, literal in self._case.expected.items()]
        parts += [_output("actual", name if named else "", literal) for name, literal in self._actual.items()]
        parts += [_call(call) for call in self._calls]
        if self._left_out:
            parts.append(f"<calls_left_out>{self._left_out}</calls_left_out>")
        if self._time is not None:
            component, hardware, stub = self._time
            parts.append(
                f'<processing_time unit="us" hardware="{hardware:.3f}" stub="{stub:.3f}">'
                f"{component:.3f}</processing_time>"
            )
        if self._message:
            parts.append(f"<message>{_escaped(_shortened(self._message))}</message>")
        parts.append("</test_result>\n")
        return "".join(parts).encode()

    def _named(self, output: str, apart: str) -> str:
        return f"{output}: {apart}" if len(self._case.expected) > 1 else apart

    def _worsen(self, verdict: Verdict, reason: str) -> None:
        self.verdict = max(self.verdict, verdict)
        self._message = f"{self._message}; {reason}" if self._message else reason


class ResultsFile:
    """The results of a run: one line, one write for each case, so that a killed process loses none.

    Through a descriptor of the agent's each line begins with its number and a token.
    """

    def __init__(self, file: Path, *, append: bool) -> None:
        """Open a file; what is there is emptied, or gone on with behind its last line, which is ended first.

        `fd:3` names a descriptor that is open. Raises CannotRunError when it is not.
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
        """Write an empty line: all is set up, and the first case begins. From then on a case's time limit holds."""
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
        """Hand the rest of a file to the disk and close."""
        if not self._token:
            os.fsync(self._descriptor)
        os.close(self._descriptor)

    def _write(self, line: bytes) -> None:
        if self._token:
            self._number += 1
            line = b"%d %b %b" % (self._number, self._token, line)
        while line:
            line = line[os.write(self._descriptor, line) :]


# What XML cannot hold, what it would not give back, and what splits lines by Unicode's rules.
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


def _output(element: str, name: str, literal: str) -> str:
    named = f' name="{_escaped(name)}"' if name else ""
    return f"<{element}{named}>{_escaped(literal)}</{element}>"


def _call(call: StubCall) -> str:
    arguments = "".join(_output("argument", name, literal) for name, literal in call.arguments.items())
    return f'<call method="{_escaped(call.method)}">{arguments}</call>'


def _shortened(text: str) -> str:
    if len(text) <= _MAX_MESSAGE_LENGTH:
        return text
    return f"{text[:_MAX_MESSAGE_LENGTH]} ... ({len(text)} characters)"
