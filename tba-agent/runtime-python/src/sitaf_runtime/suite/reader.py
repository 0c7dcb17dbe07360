"""Reads suites."""

from collections import deque
from collections.abc import Iterator
from pathlib import Path
from xml.parsers import expat

from sitaf_runtime.errors import CaseDataError
from sitaf_runtime.suite import literals
from sitaf_runtime.suite.test_case import TestCase, TestStep

_CHUNK = 1 << 16
_TEXTS = ("value", "expected")


class SuiteReader:
    """Reads a `test_suite_data` document (paper, Fig. 9) in chunks, so that memory does not grow with the suite.

    A document with a DTD is rejected. Raises OSError when the file cannot be read, CaseDataError when it is no suite.
    """

    def __init__(self, suite: Path) -> None:
        self._document = suite.name
        self._file = suite.open("rb")
        self._parser = expat.ParserCreate()
        self._parser.buffer_text = True
        self._parser.StartDoctypeDeclHandler = self._doctype
        self._parser.StartElementHandler = self._start
        self._parser.EndElementHandler = self._end
        self._parser.CharacterDataHandler = self._characters
        self._parameters: list[str] = []
        self._step_parameters: dict[str, list[str]] = {}
        # Where the next <param> belongs.
        self._current = self._parameters
        self._in_cases = False
        self._depth = 0
        self._cases: deque[TestCase] = deque()
        self._cases_read = 0
        self._attributes: dict[str, str] | None = None
        self._values: list[str] = []
        self._step: dict[str, str] | None = None
        self._step_values: list[str] = []
        self._steps: list[TestStep] = []
        self._text: list[str] | None = None
        self._ended = False
        self._error: CaseDataError | None = None
        try:
            while not self._in_cases and self._feed():
                pass
            if self._error and not self._in_cases:
                raise self._error
            if not self._in_cases:
                raise self._problem("there is no <case_list>")
        except BaseException:
            self._file.close()
            raise

    def __iter__(self) -> Iterator[TestCase]:
        """The cases. Raises CaseDataError at the first error in the document, after the cases before it."""
        while True:
            while self._cases:
                yield self._cases.popleft()
            if self._error:
                raise self._error
            if not self._feed() and not self._cases and not self._error:
                return

    def close(self) -> None:
        """Close the file."""
        self._file.close()

    def _feed(self) -> bool:
        """Read the next chunk; False at the end. Cases before an error are returned before it is raised."""
        if self._ended:
            return False
        piece = self._file.read(_CHUNK)
        self._ended = not piece
        try:
            self._parser.Parse(piece, self._ended)
        except expat.ExpatError as e:
            self._error = CaseDataError(f"{self._document}:{e.lineno}: {expat.ErrorString(e.code)}")
        except CaseDataError as e:
            self._error = e
        return self._error is None

    def _doctype(self, *_: object) -> None:
        raise self._problem("a DTD or an entity is not allowed here")

    def _start(self, tag: str, attributes: dict[str, str]) -> None:
        self._depth += 1
        if self._depth == 1:
            if tag != "test_suite_data":
                raise self._problem(f"the root is <{tag}>, not <test_suite_data>")
        elif self._attributes is not None:
            self._start_in_case(tag, attributes)
        elif tag == "param" and not self._in_cases:
            name = attributes.get("name")
            if name is None:
                raise self._problem("<param> has no attribute 'name'")
            if name in self._current:
                raise self._problem(f"two parameters are named '{name}'")
            self._current.append(name)
        elif tag == "step" and not self._in_cases:
            self._current = self._step_parameters.setdefault(self._named(tag, attributes), [])
        elif tag == "case_list":
            self._in_cases = True
        elif tag == "case" and self._in_cases:
            self._attributes = attributes
            self._values = []
            self._steps = []

    def _start_in_case(self, tag: str, attributes: dict[str, str]) -> None:
        if tag in _TEXTS and self._text is None:
            self._text = []
        elif tag == "step" and self._step is None and self._text is None:
            self._named(tag, attributes)
            self._step = attributes
            self._step_values = []
        else:
            raise self._problem(f"<{tag}> is unknown inside <{'case' if self._step is None else 'step'}>")

    def _named(self, tag: str, attributes: dict[str, str]) -> str:
        name = attributes.get("name")
        if name is None:
            raise self._problem(f"<{tag}> has no attribute 'name'")
        return name

    def _characters(self, text: str) -> None:
        if self._text is not None:
            self._text.append(text)

    def _end(self, tag: str) -> None:
        self._depth -= 1
        if self._text is not None:
            text = "".join(self._text)
            self._text = None
            # Expected values are skipped: only the agent uses them.
            if tag == "value":
                (self._values if self._step is None else self._step_values).append(text)
        elif self._step is not None and tag == "step":
            self._steps.append(self._ended_step(self._step))
            self._step = None
        elif self._attributes is not None and tag == "case":
            self._cases.append(self._case(self._attributes))
            self._attributes = None
        elif tag == "step" and not self._in_cases:
            self._current = self._parameters

    def _number(self, attributes: dict[str, str]) -> int:
        number = attributes.get("no")
        return self._cases_read + 1 if number is None else literals.whole(number, 1, (1 << 31) - 1)

    def _case(self, attributes: dict[str, str]) -> TestCase:
        no = self._number(attributes)
        self._cases_read += 1
        values = self._by_name(f"case {no}", self._parameters, self._values)
        return TestCase(no, attributes.get("class") != "invalid", values, self._steps)

    def _ended_step(self, attributes: dict[str, str]) -> TestStep:
        no = self._number(self._attributes or {})
        name = attributes["name"]
        number = len(self._steps) + 1
        what = f"step {number} ({name}) of case {no}"
        values = self._by_name(what, self._step_parameters.get(name, []), self._step_values)
        return TestStep(no, number, name, attributes.get("class") != "invalid", values)

    def _by_name(self, what: str, names: list[str], values: list[str]) -> dict[str, str]:
        if len(values) != len(names):
            raise self._problem(f"{what} has {len(values)} values for {len(names)} parameters")
        return dict(zip(names, values, strict=True))

    def _problem(self, message: str) -> CaseDataError:
        return CaseDataError(f"{self._document}:{self._parser.CurrentLineNumber}: {message}")
