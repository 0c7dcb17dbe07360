"""Executors choose which callback runs next.

At one instant, messages run in the order of their publication, then timers in the order of their creation; with
`callback_order` above 0 the choice is another one, the same in every run.
"""

from __future__ import annotations

import inspect
from collections.abc import Callable
from typing import Any

from sitaf_ros.current import CURRENT, node_threads
from sitaf_ros.node_threads import NodeThread

from .context import Context
from .exceptions import NotInitializedException
from .task import Future, Task

DEFAULT_THREADS = 8


class TimeoutException(Exception):
    """No callback became ready in time."""


class ShutdownException(Exception):
    """The executor was shut down."""


class ExternalShutdownException(Exception):
    """The context was shut down."""


class ConditionReachedException(Exception):
    """The condition of a wait came true."""


async def await_or_execute(callback: Callable[..., Any], *args: Any) -> Any:
    """Call a function or a coroutine function."""
    result = callback(*args)
    return await result if inspect.isawaitable(result) else result


class TimeoutObject:
    def __init__(self, timeout: float) -> None:
        self.timeout = timeout


class Executor:
    def __init__(self, *, context: Context | None = None) -> None:
        from .utilities import get_default_context

        self._context = get_default_context() if context is None else context
        self._nodes: list[Any] = []
        self._tasks: list[tuple[Task, Any]] = []
        self._is_shutdown = False
        self._waiting: list[NodeThread] = []
        self._running = 0
        self._context.on_shutdown(self.wake)

    @property
    def context(self) -> Context:
        return self._context

    def create_task(self, callback: Any, *args: Any, **kwargs: Any) -> Task:
        task = Task(callback, args, kwargs, executor=self)
        self._tasks.append((task, None))
        self.wake()
        return task

    def shutdown(self, timeout_sec: float | None = None) -> bool:
        self._is_shutdown = True
        self.wake()
        threads = node_threads()
        if threads is not None and self._running:
            deadline = None if timeout_sec is None else threads.now_ns + round(timeout_sec * 1e9)
            while self._running:
                self._waiting.append(threads.current())
                if not threads.wait_for_others(deadline):
                    return False
        return True

    def __enter__(self) -> Executor:
        return self

    def __exit__(self, *_: object) -> None:
        self.shutdown()

    def add_node(self, node: Any) -> bool:
        if node in self._nodes:
            return False
        self._nodes.append(node)
        node.executor = self
        self.wake()
        return True

    def remove_node(self, node: Any) -> None:
        if node in self._nodes:
            self._nodes.remove(node)
            self.wake()

    def get_nodes(self) -> list[Any]:
        return list(self._nodes)

    def wake(self) -> None:
        """Let a waiting spin look for work again."""
        waiting, self._waiting = self._waiting, []
        if CURRENT.threads is not None:
            for thread in waiting:
                CURRENT.threads.wake(thread)

    def _spins(self) -> bool:
        return self._context.ok() and not self._is_shutdown

    def spin(self) -> None:
        while self._spins():
            self.spin_once()

    def spin_until_future_complete(self, future: Future, timeout_sec: float | None = None) -> None:
        self._watch(future)
        for left in self._until(timeout_sec):
            if future.done() or future.cancelled() or not self._spins():
                return
            self.spin_once_until_future_complete(future, left)

    def _watch(self, future: Future) -> None:
        def done(_: Future) -> None:
            self.wake()

        done.runs_at_once = True  # type: ignore[attr-defined]
        future.add_done_callback(done)

    def _until(self, timeout_sec: float | None) -> Any:
        """Yield what is left of a timeout until nothing is."""
        threads = _threads()
        if timeout_sec is None or timeout_sec < 0:
            while True:
                yield None
        end = threads.now_ns + round(timeout_sec * 1e9)
        yield timeout_sec
        while threads.now_ns < end:
            yield (end - threads.now_ns) / 1e9

    def spin_once(self, timeout_sec: float | None = None) -> None:
        raise NotImplementedError

    def spin_once_until_future_complete(self, future: Future, timeout_sec: float | None = None) -> None:
        self.spin_once(timeout_sec)

    def wait_for_ready_callbacks(
        self,
        timeout_sec: float | None = None,
        nodes: list[Any] | None = None,
        condition: Callable[[], bool] = lambda: False,
    ) -> tuple[Task, Any, Any]:
        """Return a task to call, its entity and its node."""
        threads = _threads()
        forever = timeout_sec is None or timeout_sec < 0
        end = None if forever else threads.now_ns + round((timeout_sec or 0) * 1e9)
        timed_out = False
        while True:
            if threads.ending or not self._context.ok():
                self._context.case_ended()
                raise ExternalShutdownException
            if self._is_shutdown:
                raise ShutdownException
            if condition():
                raise ConditionReachedException
            found = self._next(nodes)
            if found is not None:
                return found
            if timed_out or (end is not None and end <= threads.now_ns):
                if timeout_sec == 0:
                    threads.poll()
                raise TimeoutException
            due = self._next_due(nodes)
            deadline = due if end is None else end if due is None else min(due, end)
            self._waiting.append(threads.current())
            woken = threads.wait(deadline, returns_at_end=True)
            timed_out = not woken and end is not None and threads.now_ns >= end and not self._has_ready(nodes)

    def _entities(self, nodes: list[Any] | None) -> list[tuple[Any, Any]]:
        chosen = self._nodes if nodes is None else nodes
        return [(entity, node) for node in chosen for entity in node._ros_entities]

    def _next_due(self, nodes: list[Any] | None) -> int | None:
        now = _threads().now_ns
        times = [entity.due_ns() for entity, _ in self._entities(nodes)]
        return min((time for time in times if time is not None and time > now), default=None)

    def _has_ready(self, nodes: list[Any] | None) -> bool:
        return any(entity.order() is not None for entity, _ in self._entities(nodes))

    def _next(self, nodes: list[Any] | None) -> tuple[Task, Any, Any] | None:
        system = CURRENT.system
        for pair in self._tasks:
            task, node = pair
            if task.is_ready():
                return self._step(task, node), task.entity, node
        ready = [
            (order, entity, node)
            for entity, node in self._entities(nodes)
            if (order := entity.order()) is not None and entity.callback_group.can_execute(entity)
        ]
        ready.sort(key=lambda item: item[0])
        while ready:
            varied = system is not None and system.settings.callback_order > 0 and len(ready) > 1
            _, entity, node = ready.pop(system.random.randrange(len(ready)) if varied and system is not None else 0)
            if entity.callback_group.beginning_execution(entity):
                run = entity.take()
                if run is None:
                    entity.callback_group.ending_execution(entity)
                    continue
                task = Task(run, executor=self, entity=entity, name=entity.callback_name)
                return self._step(task, node), entity, node
        return None

    def _step(self, task: Task, node: Any) -> Task:
        """Keep the task from being chosen again before it has run."""
        self._tasks = [pair for pair in self._tasks if pair[0] is not task]
        return _Step(self, task, node)

    def run_task(self, task: Task, node: Any = None) -> None:
        """Run a task until it ends or waits."""
        system = CURRENT.system
        if system is not None:
            system.count_callback()
            if task.entity is not None:
                system.unobserved.called(task.name)
        finished = True
        try:
            task()
            finished = not task._pending()
        finally:
            if finished:
                if task.entity is not None:
                    task.entity.callback_group.ending_execution(task.entity)
            else:
                if task._awaited is not None:
                    self._watch(task._awaited)
                else:
                    _threads().poll()
                self._tasks.append((task, node))
            self.wake()


class _Step(Task):
    """One call of a task by an executor, also by a user's own executor."""

    def __init__(self, executor: Executor, task: Task, node: Any) -> None:
        super().__init__(lambda: None)
        self._owner, self._task, self._node = executor, task, node
        self.entity = task.entity
        self.name = task.name

    def __call__(self) -> None:
        self._owner.run_task(self._task, self._node)

    def done(self) -> bool:
        return self._task.done()

    def result(self) -> Any:
        return self._task.result()

    def exception(self) -> BaseException | None:
        return self._task.exception()


def _threads() -> Any:
    threads = node_threads()
    if threads is None:
        raise NotInitializedException
    return threads


class SingleThreadedExecutor(Executor):
    def spin_once(self, timeout_sec: float | None = None) -> None:
        self._spin_once(timeout_sec, lambda: False)

    def spin_once_until_future_complete(self, future: Future, timeout_sec: float | None = None) -> None:
        self._spin_once(timeout_sec, future.done)

    def _spin_once(self, timeout_sec: float | None, condition: Callable[[], bool]) -> None:
        try:
            task, _, _ = self.wait_for_ready_callbacks(timeout_sec, None, condition)
        except (ShutdownException, TimeoutException, ConditionReachedException):
            return
        except ExternalShutdownException:
            if _threads().ending:
                return
            raise
        task()
        exception = task.exception()
        if exception is not None:
            raise exception


class MultiThreadedExecutor(Executor):
    """Runs callbacks in threads, of which one runs at a time; the number does not depend on the machine."""

    def __init__(self, num_threads: int | None = None, *, context: Context | None = None) -> None:
        super().__init__(context=context)
        self._limit = DEFAULT_THREADS if num_threads is None or num_threads < 1 else num_threads
        self._jobs: list[Task] = []
        self._idle: list[NodeThread] = []
        self._thrown: list[BaseException] = []
        self._threads_started = 0

    def spin_once(self, timeout_sec: float | None = None) -> None:
        self._spin_once(timeout_sec, lambda: False)

    def spin_once_until_future_complete(self, future: Future, timeout_sec: float | None = None) -> None:
        self._spin_once(timeout_sec, future.done)

    def _spin_once(self, timeout_sec: float | None, condition: Callable[[], bool]) -> None:
        threads = _threads()
        try:
            while self._running >= self._limit and not threads.ending:
                self._waiting.append(threads.current())
                threads.wait(None, returns_at_end=True)
            task, _, _ = self.wait_for_ready_callbacks(timeout_sec, None, lambda: bool(self._thrown) or condition())
        except (ShutdownException, TimeoutException, ConditionReachedException):
            self._throw()
            return
        except ExternalShutdownException:
            self._throw()
            if threads.ending:
                return
            raise
        self._running += 1
        self._jobs.append(task)
        if self._idle:
            threads.wake(self._idle.pop(0))
        else:
            self._threads_started += 1
            threads.start(f"executor-{self._threads_started}", self._work)
        self._throw()

    def _throw(self) -> None:
        if self._thrown:
            raise self._thrown.pop(0)

    def _work(self) -> None:
        threads = _threads()
        while True:
            while not self._jobs:
                self._idle.append(threads.current())
                threads.wait(None)
            task = self._jobs.pop(0)
            try:
                task()
                exception = task.exception()
                if exception is not None:
                    self._thrown.append(exception)
            except (Exception, SystemExit, KeyboardInterrupt) as e:
                self._thrown.append(e)
            finally:
                self._running -= 1
                self.wake()
