"""Replaces clocks, sleeps, threads and locks of Python by ones over simulated time, for the threads of nodes only.

The driver of the test application, in the same process, keeps the real ones.
"""

from __future__ import annotations

import _thread
import asyncio
import concurrent.futures.thread
import datetime
import queue
import random
import select
import selectors
import signal
import threading
import time
import uuid
from typing import Any

import numpy
import numpy.random

from sitaf_ros import locks
from sitaf_ros.current import CURRENT, is_simulated, node_threads

EPOCH_NS = 1_700_000_000 * 10**9
_REAL = {
    name: getattr(time, name)
    for name in (
        "sleep",
        "time",
        "time_ns",
        "monotonic",
        "monotonic_ns",
        "perf_counter",
        "perf_counter_ns",
        "process_time",
        "process_time_ns",
        "thread_time",
        "localtime",
        "gmtime",
        "ctime",
        "strftime",
        "asctime",
    )
}
_real_datetime = datetime.datetime
_real_date = datetime.date
_real_main_thread = threading.main_thread
_real_signal = signal.signal
_real_set_wakeup_fd = signal.set_wakeup_fd
_real_uuid4 = uuid.uuid4
_real_uuid1 = uuid.uuid1


def wall_ns() -> int:
    """Return the time that system clocks of nodes show: 1,700,000,000 s plus simulation time."""
    return EPOCH_NS + (0 if CURRENT.threads is None else CURRENT.threads.now_ns)


def _read(real: str, value: Any) -> Any:
    def clock() -> Any:
        if not is_simulated():
            return _REAL[real]()
        threads = node_threads()
        if threads is not None and not threads.ending:
            threads.poll()
        return value(wall_ns())

    return clock


def _sleep(seconds: float) -> None:
    """`time.sleep` in simulated time."""
    if not is_simulated():
        _REAL["sleep"](seconds)
        return
    if seconds < 0:
        raise ValueError("sleep length must be non-negative")
    threads = node_threads()
    if threads is not None:
        threads.wait(locks.seconds_from_now(threads, seconds))


def _with_default_time(name: str) -> Any:
    real = _REAL[name]

    def convert(seconds: float | None = None) -> Any:
        return real(wall_ns() / 1e9 if seconds is None and is_simulated() else seconds)

    return convert


def _strftime(form: str, when: Any = None) -> str:
    if when is None:
        return (
            _REAL["strftime"](form, _REAL["localtime"](wall_ns() / 1e9)) if is_simulated() else _REAL["strftime"](form)
        )
    return _REAL["strftime"](form, when)


class _DateTimeMeta(type):
    def __instancecheck__(cls, instance: object) -> bool:
        return isinstance(instance, _real_datetime if cls.__name__ == "datetime" else _real_date)

    def __subclasscheck__(cls, subclass: type) -> bool:
        return issubclass(subclass, _real_datetime if cls.__name__ == "datetime" else _real_date)


def _simulated_dates() -> tuple[Any, Any]:
    def now(cls: Any, tz: Any = None) -> Any:
        return _real_datetime.fromtimestamp(wall_ns() / 1e9, tz) if is_simulated() else _real_datetime.now(tz)

    def utcnow(cls: Any) -> Any:
        return now(cls, datetime.UTC).replace(tzinfo=None)

    def today(cls: Any) -> Any:
        return now(cls)

    members: dict[str, Any] = {"now": classmethod(now), "utcnow": classmethod(utcnow), "today": classmethod(today)}
    moment = _DateTimeMeta("datetime", (_real_datetime,), {**members, "__new__": _real_new(_real_datetime)})
    day: dict[str, Any] = {"today": classmethod(lambda cls: now(cls).date()), "__new__": _real_new(_real_date)}
    return moment, _DateTimeMeta("date", (_real_date,), day)


def _real_new(real: Any) -> Any:
    return lambda cls, *args, **kwargs: real(*args, **kwargs)


def _start_new_thread(function: Any, args: Any, kwargs: Any = None) -> int:
    threads = node_threads()
    if threads is None:
        return _real_start(function, args, kwargs or {})
    return threads.start(getattr(function, "__name__", "thread"), lambda: function(*args, **(kwargs or {}))).ident


_real_start = _thread.start_new_thread


def _main_thread() -> Any:
    if node_threads() is not None and CURRENT.system is not None and CURRENT.system.main_thread is not None:
        return CURRENT.system.main_thread
    return _real_main_thread()


def _signal(number: Any, handler: Any) -> Any:
    """Nodes may install handlers; no signal reaches them."""
    return signal.SIG_DFL if is_simulated() else _real_signal(number, handler)


def _set_wakeup_fd(fd: int, **kwargs: Any) -> int:
    return -1 if is_simulated() else _real_set_wakeup_fd(fd, **kwargs)


def _uuid4() -> Any:
    if not is_simulated():
        return _real_uuid4()
    return uuid.UUID(int=random.getrandbits(128), version=4)


def _uuid1(node: Any = None, clock_seq: Any = None) -> Any:
    return _uuid4() if is_simulated() else _real_uuid1(node, clock_seq)


def seed_numpy(seed: int) -> None:
    """Make generators of numpy that nodes do not seed themselves repeatable."""
    numpy_random: Any = numpy.random
    numpy_random.seed(seed % 2**32)
    real = getattr(numpy_random.default_rng, "real", numpy_random.default_rng)
    made = iter(range(seed % 2**32, 2**62))

    def default_rng(given: Any = None) -> Any:
        return real(next(made) if given is None and is_simulated() else given)

    default_rng.real = real  # type: ignore[attr-defined]
    numpy_random.default_rng = default_rng


_installed = False


def install() -> None:
    """Replace the functions; calls of other threads than those of nodes go to the real ones."""
    global _installed  # noqa: PLW0603 -- once a process
    if _installed:
        return
    _installed = True
    module: Any
    for module, name, value in _replacements():
        setattr(module, name, value)


def _replacements() -> list[tuple[Any, str, Any]]:
    moment, day = _simulated_dates()
    monotonic = _read("monotonic", lambda ns: ns / 1e9)
    replaced: list[tuple[Any, str, Any]] = [
        (time, "sleep", _sleep),
        (time, "time", _read("time", lambda ns: ns / 1e9)),
        (time, "time_ns", _read("time_ns", int)),
        (time, "monotonic", monotonic),
        (time, "monotonic_ns", _read("monotonic_ns", int)),
        (time, "perf_counter", _read("perf_counter", lambda ns: ns / 1e9)),
        (time, "perf_counter_ns", _read("perf_counter_ns", int)),
        (time, "process_time", _read("process_time", lambda ns: ns / 1e9)),
        (time, "process_time_ns", _read("process_time_ns", int)),
        (time, "thread_time", _read("thread_time", lambda ns: ns / 1e9)),
        (time, "localtime", _with_default_time("localtime")),
        (time, "gmtime", _with_default_time("gmtime")),
        (time, "ctime", _with_default_time("ctime")),
        (time, "strftime", _strftime),
        (threading, "_time", monotonic),
        (queue, "time", monotonic),
        (datetime, "datetime", moment),
        (datetime, "date", day),
        (threading, "Lock", locks.Lock),
        (threading, "_allocate_lock", locks.Lock),
        (threading, "RLock", locks.RLock),
        (threading, "Thread", locks.Thread),
        (threading, "Timer", locks.Timer),
        (threading, "main_thread", _main_thread),
        (_thread, "start_new_thread", _start_new_thread),
        (queue, "SimpleQueue", locks.SimpleQueue),
        (selectors, "DefaultSelector", locks.Selector),
        (select, "select", locks.simulated_select),
        (signal, "signal", _signal),
        (signal, "set_wakeup_fd", _set_wakeup_fd),
        (uuid, "uuid4", _uuid4),
        (uuid, "uuid1", _uuid1),
    ]
    # These use what they need by the name of the module; importing them now keeps their own locks real.
    _ = asyncio, concurrent.futures.thread
    return replaced
