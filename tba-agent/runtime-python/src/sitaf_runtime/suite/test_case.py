"""One test case."""

from collections.abc import Mapping
from typing import TypeVar

from sitaf_runtime.errors import CaseDataError
from sitaf_runtime.suite.kinds import Kind

T = TypeVar("T")


class TestCase:
    """Values by the names of the suite's parameters, and what is expected of the outputs.

    `no` is its number in the suite, and `valid` whether it holds no invalid value. `values` and `expected` hold
    literals, in the suite's order; the empty name stands for the only output.
    """

    __slots__ = ("expected", "no", "valid", "values")
    __test__ = False  # pytest: the name is the documents'

    def __init__(self, no: int, valid: bool, values: Mapping[str, str], expected: Mapping[str, str]) -> None:
        self.no = no
        self.valid = valid
        self.values = values
        self.expected = expected

    def read(self, parameter: str, kind: Kind[T]) -> T:
        """A value. Raises CaseDataError when the suite has no such parameter, or the type cannot hold its value."""
        literal = self.literal(parameter)
        try:
            return kind.parse(literal)
        except CaseDataError as e:
            raise CaseDataError(f"{parameter}: {e}") from e

    def literal(self, parameter: str) -> str:
        """A value as the suite spells it. Raises CaseDataError when there is none."""
        try:
            return self.values[parameter]
        except KeyError as e:
            raise CaseDataError(
                f"the suite has no parameter '{parameter}'; it has {', '.join(self.values)}:"
                " generate the test application anew"
            ) from e

    def expectation(self, output: str) -> str | None:
        """What is expected of an output; None when nothing is."""
        named = self.expected.get(output)
        return named if named is not None else self.expected.get("")
