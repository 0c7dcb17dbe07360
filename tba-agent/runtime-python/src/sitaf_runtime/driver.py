"""What a generated test driver is built on: the life of the component, and where results go."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, ClassVar, Generic, TypeVar

from sitaf_runtime import component as components
from sitaf_runtime.stopwatch import Stopwatch
from sitaf_runtime.stub import StubCalls
from sitaf_runtime.suite.result import CaseResult, Verdict
from sitaf_runtime.suite.test_case import TestCase

if TYPE_CHECKING:
    from sitaf_runtime.run import TestRun

C = TypeVar("C")

# Methods of the component's life, in each spelling; those that it has are called.
_BEGIN = (("on_initialize", "onInitialize", "on_initialise", "onInitialise"), ("on_start", "onStart"))
_END = (("on_stop", "onStop"), ("on_destroy", "onDestroy"), ("close",))


class SuiteDriver(ABC, Generic[C]):
    """A driver within a run.

    The component lives for each case anew, or as long as the suite where `SUITE_LIFE` says so.
    """

    SUITE_LIFE: ClassVar[bool] = False

    def __init__(self, run: TestRun) -> None:
        self._run = run
        self._component: C | None = None
        self._saved = False

    @abstractmethod
    def run_case(self, test_case: TestCase, result: CaseResult) -> None:
        """Run one case and save its result, in the five steps of Fig. 10. What the component raises makes an ERROR."""

    @abstractmethod
    def create_component(self) -> C:
        """Make the component and set it up."""

    def before_case(self, component: C, test_case: TestCase) -> None:
        """Run before each call, when the world and the stubs are set."""

    def after_case(self, component: C, test_case: TestCase) -> None:
        """Run after each call, before the result is judged."""

    @property
    def stopwatch(self) -> Stopwatch:
        """Measures the call under test."""
        return self._run.stopwatch

    @property
    def stub_calls(self) -> StubCalls:
        """What the stub is called with in a case."""
        return self._run.stub_calls

    def component(self) -> C:
        """The component of this case: made now, or that of the case before where it lives as long as the suite."""
        if self._component is None:
            self._component = self.create_component()
            for names in _BEGIN:
                self._call_hook(names)
        return self._component

    def make(self, type_: type[C], *stubs: object) -> C:
        """Make a component, with whatever of the hardware and of these stubs its constructor asks for."""
        return components.create(type_, [*stubs, *self._run.hardware()])

    def execute_periodically(self, component: C, period_s: float) -> None:
        """Let the component's `on_execute` be called whenever its period has passed in simulation time."""
        self._run.simulation.every(period_s, components.method_of(component, "onExecute"))

    def timed(self, call: Callable[..., Any], *arguments: Any) -> Any:
        """Make the call under test and give what it returns; nothing else is measured."""
        watch = self._run.stopwatch
        watch.start()
        returned = call(*arguments)
        watch.stop()
        return returned

    def save(self, result: CaseResult) -> None:
        """Hand the result of the case, with the time of its call, over to the results file."""
        watch = self._run.stopwatch
        result.took(watch.component_us, watch.hardware_us, watch.stub_us)
        result.called(self._run.stub_calls.calls, self._run.stub_calls.left_out)
        too_long = self._run.took_too_long
        if too_long:
            result.ended_with(Verdict.ERROR, too_long)
        self._run.results.save(result)
        self._saved = True

    @property
    def is_saved(self) -> bool:
        """Whether the result of the current case is in the file."""
        return self._saved

    def begin_case(self) -> None:
        """Begin a case."""
        self._saved = False
        self._run.stub_calls.reset()

    def end_case(self) -> None:
        """End the life of a component that lives for one case."""
        if not self.SUITE_LIFE:
            self.close()

    def close(self) -> None:
        """End the life of the component."""
        if self._component is None:
            return
        try:
            for names in _END:
                self._call_hook(names)
        finally:
            self._component = None

    def _call_hook(self, names: tuple[str, ...]) -> None:
        name = components.has_method(self._component, *names)
        if name is not None:
            getattr(self._component, name)()
