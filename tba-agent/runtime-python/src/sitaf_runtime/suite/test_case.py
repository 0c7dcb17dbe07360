"""One test case."""

from collections.abc import Callable, Mapping, Sequence
from typing import Any, TypeVar

from sitaf_runtime.errors import CaseDataError
from sitaf_runtime.suite.kinds import Kind

T = TypeVar("T")


class TestCase:
    """Values by the names of the suite's parameters.

    `no` is its number in the suite, `valid` whether it has no invalid value; `values` are literals by parameter.
    `steps` are those of a sequence.
    """

    __slots__ = ("no", "steps", "valid", "values")
    __test__ = False  # not a test of pytest

    def __init__(self, no: int, valid: bool, values: Mapping[str, str], steps: "Sequence[TestStep]" = ()) -> None:
        self.no = no
        self.valid = valid
        self.values = values
        self.steps = steps

    def read(self, parameter: str, kind: Kind[T]) -> T:
        """Get a value. Raises CaseDataError when the suite has no such parameter or the type cannot hold its value."""
        literal = self.literal(parameter)
        try:
            return kind.parse(literal)
        except CaseDataError as e:
            raise CaseDataError(f"{parameter}: {e}") from e

    def assemble(self, kind: Kind[T], parts: Mapping[str, tuple[str | int, ...]]) -> T:
        """Build a value from several parameters, each with the path of its part in the value.

        `assemble(struct(Pose), {"pose.x": ("x",)})`; parts without a parameter have the default of their type. Raises
        CaseDataError as `read` does.
        """
        whole = kind.zero()
        for parameter, path in parts.items():
            _put(whole, kind, path, lambda leaf, parameter=parameter: self.read(parameter, leaf))
        return whole

    def literal(self, parameter: str) -> str:
        """The literal of a parameter. Raises CaseDataError when there is none."""
        try:
            return self.values[parameter]
        except KeyError as e:
            raise CaseDataError(
                f"the suite has no parameter '{parameter}'; it has {', '.join(self.values)}:"
                " generate the test application again"
            ) from e


class TestStep(TestCase):
    """A step of a sequence: a call with its values, or an event without values.

    `number` is that of the step in its case, from 1; `name` is the call or event of the test model.
    """

    __slots__ = ("name", "number")

    def __init__(self, no: int, number: int, name: str, valid: bool, values: Mapping[str, str]) -> None:
        super().__init__(no, valid, values)
        self.number = number
        self.name = name


def _put(whole: Any, kind: Kind[Any], path: tuple[str | int, ...], read: Callable[[Kind[Any]], Any]) -> None:
    """Set a part of a value; sequences are extended as needed."""
    step, rest = path[0], path[1:]
    part = kind.part(step) if kind.part else None
    if part is None:
        raise CaseDataError(f"there is no part {step}")
    if isinstance(step, int):
        while len(whole) <= step:
            whole.append(part.zero())
        if rest:
            _put(whole[step], part, rest, read)
        else:
            whole[step] = read(part)
    elif rest:
        _put(getattr(whole, step), part, rest, read)
    else:
        setattr(whole, step, read(part))
