"""What the test stub answers for required interfaces."""

from __future__ import annotations

import re
import time
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Generic, TypeVar

from sitaf_runtime.errors import CaseDataError
from sitaf_runtime.stopwatch import Stopwatch
from sitaf_runtime.suite import literals
from sitaf_runtime.suite.calls import StubCall
from sitaf_runtime.suite.kinds import Kind

if TYPE_CHECKING:
    from sitaf_runtime.simulation.session import Simulation

T = TypeVar("T")
_DELAYED = re.compile(r"!delay:([0-9]{1,6}(?:\.[0-9]{1,9})?)(?: (.*))?", re.DOTALL | re.ASCII)
_ERROR = "!error:"


@dataclass(frozen=True, slots=True)
class Answer(Generic[T]):
    """What a stubbed method does: it waits, then raises the error or returns the value."""

    value: T | None
    delay_s: float = 0.0
    error: type[Exception] | None = None


def answer(kind: Kind[T] | None, errors: Mapping[str, type[Exception]]) -> Kind[Answer[T]]:
    """Answers of a case: `VALUE`, `!error:NAME`, `!delay:SECONDS`, or a delay, a space and another.

    `kind` is None for a method that returns nothing.
    """

    def parse(literal: str) -> Answer[T]:
        rest: str | None = literal
        delay = 0.0
        if literal.startswith("!delay:"):
            delayed = _DELAYED.fullmatch(literal)
            if not delayed:
                raise CaseDataError(f"'{literal}' is not a delay such as !delay:0.5 or !delay:0.5 VALUE, in seconds")
            delay = float(delayed[1])
            rest = delayed[2]
        if rest is not None and rest.startswith(_ERROR):
            name = rest.removeprefix(_ERROR)
            if name not in errors:
                raise CaseDataError(f"'{name}' is no error of this test; it has {', '.join(errors) or 'none'}")
            return Answer(None, delay, errors[name])
        if kind is None:
            return Answer(None, delay)
        return Answer(kind.zero() if rest is None else kind.parse(rest), delay)

    return Kind(parse, lambda: Answer(None if kind is None else kind.zero()))


class Stubbing:
    """What the stubbed methods of a run share: the clock, the record of a case's calls, and how time passes."""

    # A component may call without end.
    MOST = 1_000

    def __init__(self, stopwatch: Stopwatch, simulation: Simulation | None = None) -> None:
        """`simulation` is whose time a delayed answer takes; None where real time passes."""
        self.stopwatch = stopwatch
        self._simulation = simulation
        self.calls: list[StubCall] = []
        self.left_out = 0

    def begin(self) -> None:
        """Begin a case: clear the recorded calls."""
        self.calls = []
        self.left_out = 0

    def has_room(self) -> bool:
        """Whether one more call is kept."""
        return len(self.calls) < self.MOST

    def record(self, method: str, arguments: dict[str, str]) -> None:
        """Keep a call, from any thread."""
        if self.has_room():
            self.calls.append(StubCall(method, arguments))
        else:
            self.left_out += 1

    def let_pass(self, delay_s: float) -> None:
        """Wait for a delayed answer."""
        if self._simulation is None:
            time.sleep(delay_s)
        else:
            self._simulation.advance(delay_s)


class StubbedMethod(Generic[T]):
    """One method of a required interface, as the test stub answers it.

    From one call on to the next that has its own, every call gets the same answer. `name` is `Interface.Method`, `kind`
    None where it returns nothing, `inputs` and `outs` the kinds of its parameters by name; what goes both ways is in
    both.
    """

    def __init__(
        self,
        stubbing: Stubbing,
        name: str,
        kind: Kind[T] | None,
        inputs: Mapping[str, Kind[Any]] | None = None,
        outs: Mapping[str, Kind[Any]] | None = None,
    ) -> None:
        self._stubbing = stubbing
        self._name = name
        self._kind = kind
        self._inputs = dict(inputs or {})
        self._outs = dict(outs or {})
        self._count = 0
        self._answers: dict[str, list[tuple[int, Any]]] = {}
        self.reset()

    def reset(self) -> None:
        """Go back to the zero of each type, and count from 1 again."""
        self._count = 0
        self._answers = {name: [(1, kind.zero())] for name, kind in self._outs.items()}
        self._answers[""] = [(1, None if self._kind is None else self._kind.zero())]

    def answer(self, value: T | Answer[T], from_call: int = 1, out: str = "") -> None:
        """Set the answer from a call on, counted from 1: of the return value, or of an out-parameter."""
        self._answers[out].append((from_call, value))

    def call(self, *arguments: Any) -> Any:
        """What the component gets; the time counts as the stub's.

        A method with out-parameters gives a tuple: the return value, where there is one, then each of them.
        """
        entered = time.perf_counter_ns()
        try:
            self._count += 1
            self._record(arguments)
            value = self._current("")
            if isinstance(value, Answer):
                if value.delay_s:
                    self._stubbing.let_pass(value.delay_s)
                if value.error:
                    raise value.error(f"{self._name} raises this error in this case")
                value = value.value
            if not self._outs:
                return value
            parts = [self._current(out) for out in self._outs]
            parts = parts if self._kind is None else [value, *parts]
            return parts[0] if len(parts) == 1 else tuple(parts)
        finally:
            self._stubbing.stopwatch.leave_stub(entered)

    def _record(self, arguments: tuple[Any, ...]) -> None:
        given = zip(self._inputs.items(), arguments, strict=True)
        written = {n: literals.write(kind.shaped(a)) for (n, kind), a in given} if self._stubbing.has_room() else {}
        self._stubbing.record(self._name, written)

    def _current(self, out: str) -> Any:
        current = None
        for from_call, value in self._answers[out]:
            if from_call <= self._count:
                current = value
        return current
