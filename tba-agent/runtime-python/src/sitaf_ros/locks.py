"""Locks, queues and threads of nodes; they replace those of `threading` and `queue` for nodes only."""

from __future__ import annotations

import _thread
import queue
import select
import selectors
import threading
from typing import Any

from sitaf_ros.current import CURRENT, is_simulated, node_threads
from sitaf_ros.errors import is_regular_end
from sitaf_ros.node_threads import CaseEnded, NodeThread, NodeThreads

RealLock = _thread.allocate_lock
RealRLock = threading.RLock
RealThread = threading.Thread
RealSimpleQueue = queue.SimpleQueue
RealSelector = selectors.DefaultSelector
real_select = select.select
PyRLock: Any = getattr(threading, "_PyRLock")  # noqa: B009 -- private, but there since Python 3.2
PySimpleQueue: Any = getattr(queue, "_PySimpleQueue")  # noqa: B009


def seconds_from_now(threads: NodeThreads, seconds: float | None) -> int | None:
    """Return the simulation time of a timeout; None for no timeout."""
    return None if seconds is None else threads.now_ns + max(0, round(seconds * 1e9))


class SimulatedLock:
    """A lock between threads of which only one runs at a time."""

    def __init__(self) -> None:
        self._held = False
        self._waiting: list[NodeThread] = []

    def acquire(self, blocking: bool = True, timeout: float = -1) -> bool:
        """Take the lock, waiting in simulated time."""
        if not self._held:
            self._held = True
            return True
        if not blocking or timeout == 0:
            return False
        threads = node_threads()
        if threads is None:
            raise RuntimeError("a lock of a ROS node is held while its threads wait: this would wait for ever")
        deadline = None if timeout < 0 else seconds_from_now(threads, timeout)
        me = threads.current()
        while self._held:
            self._waiting.append(me)
            woken = threads.wait_for_others(deadline)
            if me in self._waiting:
                self._waiting.remove(me)
            if not woken and self._held:
                return False
        self._held = True
        return True

    def release(self) -> None:
        """Release the lock and wake the thread that waits longest."""
        if not self._held:
            raise RuntimeError("release unlocked lock")
        self._held = False
        if self._waiting and CURRENT.threads is not None:
            CURRENT.threads.wake(self._waiting.pop(0))

    def locked(self) -> bool:
        """Tell whether the lock is held."""
        return self._held

    def __enter__(self) -> bool:
        return self.acquire()

    def __exit__(self, *_: object) -> None:
        self.release()

    def _at_fork_reinit(self) -> None:
        self.__init__()


class Lock:
    """Makes a simulated lock for nodes and a real one for everything else."""

    def __new__(cls) -> Any:
        """Make the lock."""
        return SimulatedLock() if is_simulated() else RealLock()


class RLock:
    """Makes a simulated reentrant lock for nodes and a real one for everything else."""

    def __new__(cls) -> Any:
        """Make the lock."""
        return PyRLock() if is_simulated() else RealRLock()


class SimpleQueue:
    """Makes a simulated queue for nodes and a real one for everything else."""

    def __new__(cls) -> Any:
        """Make the queue."""
        return PySimpleQueue() if is_simulated() else RealSimpleQueue()

    __class_getitem__ = classmethod(lambda cls, item: cls)


class _ThreadMeta(type):
    def __instancecheck__(cls, instance: object) -> bool:
        return isinstance(instance, RealThread) if cls.__name__ == "Thread" else super().__instancecheck__(instance)


class Thread(RealThread, metaclass=_ThreadMeta):
    """A thread that runs over simulated time when a node starts it."""

    _sitaf_thread: NodeThread | None = None

    def start(self) -> None:
        """Start the thread."""
        threads = node_threads()
        if threads is None:
            if CURRENT.loading_thread == threading.get_ident():
                raise RuntimeError("a module of a ROS node starts a thread while it is imported; start it in a node")
            super().start()
            return
        if self._sitaf_thread is not None:
            raise RuntimeError("threads can only be started once")

        def run() -> None:
            try:
                self.run()
            except (SystemExit, CaseEnded):
                pass  # the regular ways to end a thread
            except BaseException as e:
                if CURRENT.system is None:
                    return
                if is_regular_end(e):
                    # ROS prints the exception, and the node goes on.
                    CURRENT.system.unobserved.warn(f"thread {self.name} ended with {type(e).__name__} at the shutdown")
                    return
                CURRENT.system.failed(f"thread {self.name}", e)

        self._sitaf_begin(threads, run)

    def _sitaf_begin(self, threads: NodeThreads, main: Any) -> None:
        """Start the thread with another function than `run`."""
        active: dict[int, Any] = getattr(threading, "_active")  # noqa: B009

        def begin(ident: int) -> None:
            self._ident = ident  # type: ignore[attr-defined]
            active[ident] = self
            self._started.set()  # type: ignore[attr-defined]

        def run() -> None:
            try:
                main()
            finally:
                active.pop(threading.get_ident(), None)

        self._sitaf_thread = threads.start(self.name, run, begin)

    def join(self, timeout: float | None = None) -> None:
        """Wait until the thread has ended."""
        if self._sitaf_thread is None:
            if not self._started.is_set():  # type: ignore[attr-defined]
                raise RuntimeError("cannot join thread before it is started")
            super().join(timeout)
            return
        threads = node_threads()
        if threads is not None:
            threads.join(self._sitaf_thread, seconds_from_now(threads, timeout))

    def is_alive(self) -> bool:
        """Tell whether the thread runs."""
        return super().is_alive() if self._sitaf_thread is None else not self._sitaf_thread.finished

    def __repr__(self) -> str:
        return f"<{type(self).__name__}({self.name})>"


class Timer(Thread):
    """Calls a function after a time: `threading.Timer` over simulated time."""

    def __init__(self, interval: float, function: Any, args: Any = None, kwargs: Any = None) -> None:
        super().__init__()
        self.interval, self.function = interval, function
        self.args, self.kwargs = args or [], kwargs or {}
        self.finished = threading.Event()

    def cancel(self) -> None:
        """Keep the function from being called."""
        self.finished.set()

    def run(self) -> None:
        """Wait, then call the function."""
        self.finished.wait(self.interval)
        threads = CURRENT.threads
        if not self.finished.is_set() and not (threads is not None and threads.ending):
            self.function(*self.args, **self.kwargs)
        self.finished.set()


class SimulatedSelector(RealSelector):
    """A selector whose timeout is simulated time; asyncio waits in it."""

    def select(self, timeout: float | None = None) -> Any:
        """Return what is ready, waiting in simulated time."""
        threads = node_threads()
        ready = super().select(0 if threads is not None else timeout)
        if ready or threads is None or (timeout is not None and timeout <= 0):
            if threads is not None:
                threads.poll()
            return ready
        real = super().select
        threads.wait(seconds_from_now(threads, timeout), poll=lambda: bool(real(0)))
        return real(0)


class Selector:
    """Makes a simulated selector for nodes and a real one for everything else."""

    def __new__(cls) -> Any:
        """Make the selector."""
        return SimulatedSelector() if is_simulated() else RealSelector()


def simulated_select(read: Any, write: Any, error: Any, timeout: float | None = None) -> Any:
    """`select.select` with a timeout in simulated time."""
    threads = node_threads()
    if threads is None:
        return real_select(read, write, error, timeout)
    stdin: Any = None if CURRENT.system is None else CURRENT.system.stdin

    def ready() -> Any:
        found = real_select(read, write, error, 0)
        buffered = stdin is not None and stdin in read and stdin.has_text and stdin not in found[0]
        return ([*found[0], stdin], found[1], found[2]) if buffered else found

    def look() -> bool:
        if stdin is not None and stdin in read:
            stdin.feed()
        return any(ready())

    if look() or timeout == 0:
        threads.poll()
    else:
        threads.wait(seconds_from_now(threads, timeout), poll=look)
    return ready()
