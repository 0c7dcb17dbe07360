"""Reads suites."""

from collections import deque
from collections.abc import Iterator
from pathlib import Path
from xml.parsers import expat

from sitaf_runtime.errors import CaseDataError
from sitaf_runtime.suite import literals
from sitaf_runtime.suite.test_case import TestCase

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
        self._in_cases = False
        self._depth = 0
        self._cases: deque[TestCase] = deque()
        self._cases_read = 0
        self._attributes: dict[str, str] | None = None
        self._values: list[str] = []
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
            if tag not in _TEXTS or self._text is not None:
                raise self._problem(f"<{tag}> is unknown inside <case>")
            self._text = []
        elif tag == "param" and not self._in_cases:
            name = attributes.get("name")
            if name is None:
                raise self._problem("<param> has no attribute 'name'")
            if name in self._parameters:
                raise self._problem(f"two parameters are named '{name}'")
            self._parameters.append(name)
        elif tag == "case_list":
            self._in_cases = True
        elif tag == "case" and self._in_cases:
            self._attributes = attributes
            self._values = []

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
                self._values.append(text)
        elif self._attributes is not None and tag == "case":
            self._cases.append(self._case(self._attributes))
            self._attributes = None

    def _case(self, attributes: dict[str, str]) -> TestCase:
        self._cases_read += 1
        number = attributes.get("no")
        no = self._cases_read if number is None else literals.whole(number, 1, (1 << 31) - 1)
        if len(self._values) != len(self._parameters):
            raise self._problem(f"case {no} has {len(self._values)} values for {len(self._parameters)} parameters")
        values = dict(zip(self._parameters, self._values, strict=True))
        return TestCase(no, attributes.get("class") != "invalid", values)

    def _problem(self, message: str) -> CaseDataError:
        return CaseDataError(f"{self._document}:{self._parser.CurrentLineNumber}: {message}")
