"""Base class of the generated test drivers: life cycle of the component and results."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping, Sequence
from threading import get_ident
from typing import TYPE_CHECKING, Any, ClassVar, Generic, TypeVar

from sitaf_runtime import component as components
from sitaf_runtime.hooks import Hooks
from sitaf_runtime.nonblocking import NonblockingCall
from sitaf_runtime.stopwatch import Stopwatch
from sitaf_runtime.suite import literals
from sitaf_runtime.suite.kinds import Kind
from sitaf_runtime.suite.result import CaseResult, Outcome
from sitaf_runtime.suite.test_case import TestCase

if TYPE_CHECKING:
    from sitaf_runtime.run import TestRun

C = TypeVar("C")
T = TypeVar("T")


class SuiteDriver(ABC, Generic[C]):
    """The test driver of a run.

    A component is created for each case, or once per suite with `SUITE_LIFE`. `NOT_HOOKS` names
    methods of its interfaces, which are never called as hooks.
    """

    SUITE_LIFE: ClassVar[bool] = False
    NOT_HOOKS: ClassVar[Sequence[str]] = ()

    def __init__(self, run: TestRun) -> None:
        self._run = run
        self._hooks = Hooks(self.NOT_HOOKS)
        self._component: C | None = None
        self._begun: C | None = None
        # Nonblocking calls whose outcome is not yet read, by the thread that began each.
        self._pending: dict[int, NonblockingCall[Any]] = {}
        self._saved = False

    @abstractmethod
    def run_case(self, test_case: TestCase, result: CaseResult) -> None:
        """Run one case and save its result, in the five steps of Fig. 10."""

    @abstractmethod
    def create_component(self) -> C:
        """Create the component and set its properties."""

    def before_case(self, component: C, test_case: TestCase) -> None:
        """Called before each call under test, after the world and the stubs are set up."""

    def after_case(self, component: C, test_case: TestCase) -> None:
        """Called after each call under test, before the result is saved."""

    @property
    def stopwatch(self) -> Stopwatch:
        """Measures the call under test."""
        return self._run.stopwatch.of_this_thread

    def component(self) -> C:
        """The component of this case: a new one, or that of the previous case with `SUITE_LIFE`."""
        if self._component is None:
            self._component = self.create_component()
            self.begin(self._component)
        return self._component

    def make(self, type_: type[C], *stubs: object, inputs: Mapping[str, object] | None = None) -> C:
        """Create a component; its constructor gets the hardware, the stubs and the inputs that it needs.

        Inputs that the constructor does not take are set as properties.
        """
        left = dict(inputs or {})
        component = components.create(type_, [*stubs, *self._run.hardware()], left)
        for name, value in left.items():
            components.set_input(component, name, value)
        return component

    def begin(self, component: C) -> None:
        """Initialise and start a component if its class has the methods; repeated calls do nothing."""
        if self._begun is not component:
            self._begun = component
            self._hooks.begin(component)

    def execute_periodically(self, component: C, period_s: float) -> None:
        """Let the component's `onExecute` be called whenever its period has passed in simulation time."""
        self._run.simulation.every(period_s, self._hooks.execution(component))

    def call_nonblocking(self, call: Callable[..., T], *arguments: Any) -> NonblockingCall[T]:
        """Start a nonblocking call of the component; it is measured on its own thread."""
        nonblocking = NonblockingCall(self._run.stopwatch, self._run.simulation_if_any, lambda: call(*arguments))
        self._pending[get_ident()] = nonblocking
        return nonblocking

    def watch(self, signal: str, read: Callable[[], Any], kind: Kind[Any]) -> None:
        """Record the value of an output data port, or of a part of it, whenever it changes in this case."""
        self._run.watch(signal, lambda: literals.write(kind.shaped(read())))

    def timed(self, call: Callable[..., Any], *arguments: Any) -> Any:
        """Make and measure the call under test, and return its value."""
        watch = self.stopwatch
        watch.start()
        returned = call(*arguments)
        watch.stop()
        return returned

    def save(self, result: CaseResult) -> None:
        """Write the result of the case, with the time of its call, to the results file."""
        watch = self._run.stopwatch
        result.set_time(watch.component_us, watch.hardware_us, watch.stub_us)
        too_long = self._run.took_too_long
        if too_long:
            result.end_with(Outcome.ERROR, too_long)
        self._run.read_ports()
        self._run.save(result)
        self._saved = True

    def save_sequence(self, result: CaseResult) -> None:
        """Write the end of a sequence, whose steps have their own times."""
        self._run.read_ports()
        self._run.save(result)
        self._saved = True

    @property
    def is_saved(self) -> bool:
        """Whether the result of the current case was saved."""
        return self._saved

    def begin_case(self) -> None:
        """Begin a case."""
        self._saved = False
        self._pending.clear()
        self._run.stubbing.begin()

    def give_up(self) -> None:
        """Wait for the end of a nonblocking call that is still running."""
        pending = self._pending.pop(get_ident(), None) if self._pending else None
        if pending is not None:
            pending.give_up()

    def end_case(self) -> None:
        """Stop and close the component if it is created for each case."""
        if not self.SUITE_LIFE:
            self.close()

    def close(self) -> None:
        """Stop and close the component."""
        if self._component is None:
            return
        try:
            self._hooks.end(self._component)
        finally:
            self._component = None
            self._begun = None
