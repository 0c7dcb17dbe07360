"""Base of the generated test stubs of required interfaces."""

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
    """The behaviour of a stubbed method: it waits, then raises the error or returns the value."""

    value: T | None
    delay_s: float = 0.0
    error: type[Exception] | None = None


def answer(kind: Kind[T] | None, errors: Mapping[str, type[Exception]]) -> Kind[Answer[T]]:
    """Reads answers: `VALUE`, `!error:NAME` or `!delay:SECONDS`; a value or an error may follow a delay after a space.

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
    """State that the stubbed methods of a run share: stopwatch, recorded calls, and simulation."""

    # Maximum number of recorded calls per case; a component may make any number of calls.
    MOST = 1_000

    def __init__(self, stopwatch: Stopwatch, simulation: Simulation | None = None) -> None:
        """`simulation` delays answers in simulation time; None for real time."""
        self.stopwatch = stopwatch
        self._simulation = simulation
        self.calls: list[StubCall] = []
        self.left_out = 0

    def begin(self) -> None:
        """Start a case: clear the recorded calls."""
        self.calls = []
        self.left_out = 0

    def has_room(self) -> bool:
        """Whether the next call is recorded."""
        return len(self.calls) < self.MOST

    def record(self, method: str, arguments: dict[str, str]) -> None:
        """Record a call. Thread-safe."""
        if self.has_room():
            self.calls.append(StubCall(method, arguments))
        else:
            self.left_out += 1

    def take(self) -> tuple[list[StubCall], int]:
        """The calls recorded so far and the number of those left out; later ones belong to another step."""
        taken = self.calls, self.left_out
        self.begin()
        return taken

    def let_pass(self, delay_s: float) -> None:
        """Wait for a delayed answer."""
        if self._simulation is None:
            time.sleep(delay_s)
        else:
            self._simulation.advance(delay_s)


class StubbedMethod(Generic[T]):
    """A method of a required interface in the test stub.

    An answer applies from its call until the next call that has an answer. `name` is `Interface.Method`; `kind` is None
    when the method returns nothing; `inputs` and `outs` are the kinds of its parameters by name, with in-out-parameters
    in both.
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
        # The number of calls before the answers were replaced, from which their calls count.
        self._before: dict[str, int] = {}
        self.reset()

    def reset(self) -> None:
        """Reset the answers to the default value of each type, and restart the count of calls."""
        self._count = 0
        self._before = {}
        self._answers = {name: [(1, kind.zero())] for name, kind in self._outs.items()}
        self._answers[""] = [(1, None if self._kind is None else self._kind.zero())]

    def answer(self, value: T | Answer[T], from_call: int = 1, out: str = "") -> None:
        """Set the answer from a call (counted from 1) onwards, for the return value or for an out-parameter."""
        self._answers[out].append((from_call, value))

    def replace(self, by_call: Mapping[int, T | Answer[T]], out: str = "") -> None:
        """Replace the answers in the running case; their calls (from 1) count from now on."""
        kind = self._outs[out] if out else self._kind
        self._before[out] = self._count
        self._answers[out] = [(1, None if kind is None else kind.zero()), *sorted(by_call.items())]

    def call(self, *arguments: Any) -> Any:
        """Handle a call of the component; its time counts as time in stubs.

        A method with out-parameters returns a tuple: the return value, if there is one, then each out-parameter.
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
        number = max(1, self._count - self._before.get(out, 0))
        for from_call, value in self._answers[out]:
            if from_call <= number:
                current = value
        return current
