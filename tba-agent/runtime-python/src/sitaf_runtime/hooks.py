"""Calls the life-cycle methods and the periodic method of a component, which are found by name."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Sequence
from typing import Any

from sitaf_runtime.component import snake_case
from sitaf_runtime.errors import CannotRunError

_INITIALISE = ("initialise", "initialize", "onInitialize")
_START = ("start", "onStart")
_STOP = ("stop", "onStop")
_DESTROY = ("destroy", "onDestroy")
_CLOSE = ("close",)
_EXECUTE = ("onExecute", "execute")


class Hooks:
    """Hooks of a component. Methods of its interfaces are no hooks, in camelCase or snake_case."""

    def __init__(self, not_hooks: Sequence[str] = ()) -> None:
        self._not_hooks = {spelling for name in not_hooks for spelling in (name, snake_case(name))}

    def begin(self, component: object) -> None:
        """Initialise and start a component if it has the methods."""
        self._call(component, _INITIALISE)
        self._call(component, _START)

    def end(self, component: object) -> None:
        """Stop, destroy and close a component if it has the methods."""
        try:
            self._call(component, _STOP)
            self._call(component, _DESTROY)
        finally:
            self._call(component, _CLOSE)

    def execution(self, component: object) -> Callable[[], Any]:
        """The method that executes one period. Raises CannotRunError when the component has none."""
        hook = self._find(component, _EXECUTE)
        if hook is None:
            raise CannotRunError(
                f"{type(component).__module__}.{type(component).__qualname__} has no method onExecute, on_execute or"
                " execute without parameters, which activity.yaml's execution: periodic asks for"
            )
        return hook

    def _call(self, component: object, names: Sequence[str]) -> None:
        hook = self._find(component, names)
        if hook is not None:
            hook()

    def _find(self, component: object, names: Sequence[str]) -> Callable[[], Any] | None:
        for name in names:
            for spelling in dict.fromkeys((name, snake_case(name))):
                hook = getattr(component, spelling, None)
                if spelling not in self._not_hooks and callable(hook) and _takes_nothing(hook):
                    return hook
        return None


def _takes_nothing(hook: Callable[..., Any]) -> bool:
    try:
        inspect.signature(hook).bind()
    except TypeError:
        return False
    except ValueError:
        pass  # A method of an extension module may not say.
    return True
