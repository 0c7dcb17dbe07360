"""Futures, and tasks that an executor runs."""

from __future__ import annotations

import inspect
import weakref
from collections.abc import Callable, Generator
from typing import Any

from sitaf_ros.callback_names import callback_name
from sitaf_ros.current import CURRENT, node_threads
from sitaf_ros.errors import is_regular_end


class _Awaited:
    """The future that the coroutine just began to wait for; only one thread runs at a time."""

    future: Future | None = None


class Future:
    def __class_getitem__(cls, item: Any) -> Any:
        return cls

    def __init__(self, *, executor: Any = None) -> None:
        self._done = False
        self._cancelled = False
        self._result: Any = None
        self._exception: BaseException | None = None
        self._exception_fetched = False
        self._callbacks: list[Callable[[Any], Any]] = []
        self._executor: Any = None
        self._set_executor(executor)

    def __await__(self) -> Generator[None, None, Any]:
        while self._pending():
            _Awaited.future = self
            yield
        return self.result()

    def _pending(self) -> bool:
        return not self._done and not self._cancelled

    def cancel(self) -> None:
        if not self._done:
            self._cancelled = True
            self._finish()

    def cancelled(self) -> bool:
        return self._cancelled

    def done(self) -> bool:
        return self._done

    def result(self) -> Any:
        if self._exception:
            raise self.exception()  # type: ignore[misc]
        return self._result

    def exception(self) -> BaseException | None:
        self._exception_fetched = True
        return self._exception

    def set_result(self, result: Any) -> None:
        self._result, self._done, self._cancelled = result, True, False
        self._finish()

    def set_exception(self, exception: BaseException) -> None:
        self._exception, self._done, self._cancelled = exception, True, False
        self._exception_fetched = False
        self._finish()

    def _finish(self) -> None:
        executor = self._executor() if self._executor is not None else None
        callbacks, self._callbacks = self._callbacks, []
        for callback in callbacks:
            if executor is not None and not getattr(callback, "runs_at_once", False):
                executor.create_task(callback, self)
            else:
                self._call(callback)

    def _call(self, callback: Callable[[Any], Any]) -> None:
        try:
            callback(self)
        except Exception as e:
            if CURRENT.system is not None and not is_regular_end(e):
                CURRENT.system.failed(f"callback {callback_name(callback)}", e)
            raise

    def _set_executor(self, executor: Any) -> None:
        self._executor = None if executor is None else weakref.ref(executor)

    def add_done_callback(self, callback: Callable[[Any], Any]) -> None:
        if not self._done:
            self._callbacks.append(callback)
            return
        executor = self._executor() if self._executor is not None else None
        if executor is not None:
            executor.create_task(callback, self)
        else:
            callback(self)

    def remove_done_callback(self, callback: Callable[[Any], Any]) -> bool:
        before = len(self._callbacks)
        self._callbacks = [c for c in self._callbacks if c != callback]
        return len(self._callbacks) < before


class Task(Future):
    """Runs a function or coroutine; each call runs it until it waits for a future."""

    def __init__(
        self,
        handler: Callable[..., Any] | Any,
        args: Any = None,
        kwargs: Any = None,
        executor: Any = None,
        entity: Any = None,
        name: str | None = None,
    ) -> None:
        super().__init__(executor=executor)
        self._handler = handler
        self._args, self._kwargs = args or (), kwargs or {}
        self._coroutine: Any = handler if inspect.iscoroutine(handler) else None
        self._executing = False
        self._awaited: Future | None = None
        self.entity = entity
        self.name = name or callback_name(handler)

    def __call__(self) -> None:
        if not self._pending() or self._executing:
            return
        self._executing = True
        threads = node_threads()
        if self.entity is not None and threads is not None:
            self.entity.running_in = threads.current()
        try:
            if self._coroutine is None:
                result = self._handler(*self._args, **self._kwargs)
                if not inspect.iscoroutine(result):
                    self.set_result(result)
                    return
                self._coroutine = result
            _Awaited.future = None
            self._coroutine.send(None)
            self._awaited = _Awaited.future
        except StopIteration as e:
            self.set_result(e.value)
        except Exception as e:
            if CURRENT.system is not None and not is_regular_end(e):
                CURRENT.system.failed(f"callback {self.name}", e)
            self.set_exception(e)
        finally:
            self._executing = False
            if self.entity is not None:
                self.entity.running_in = None

    def executing(self) -> bool:
        return self._executing

    def is_ready(self) -> bool:
        """Tell whether a call would do something."""
        waits = self._awaited is not None and self._awaited._pending()
        return self._pending() and not self._executing and not waits
