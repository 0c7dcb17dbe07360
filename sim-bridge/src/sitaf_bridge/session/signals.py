"""The signals of finished cases, until the agent takes them."""

import threading
from dataclasses import dataclass

from sitaf_bridge.errors import BridgeError, InvalidRequest, LimitReached
from sitaf_bridge.world.driving.signals import Trace

# 256 MB of signals that were not taken yet.
MAX_NUMBERS = 32_000_000
MAX_CASES = 100_000


@dataclass(frozen=True)
class SignalOrder:
    """The names of the signals to record, and whether also while the world settles."""

    names: tuple[str, ...]
    settling: bool


@dataclass
class _Kept:
    trace: Trace | BridgeError
    times: int = 1


class SignalStore:
    """Traces by the number of their case. Thread-safe.

    A component can make the calls of its test application. Its trace replaces none: a case that was kept twice has
    `times` 2, which the agent reports.
    """

    def __init__(self, order: SignalOrder) -> None:
        self.order = order
        self._lock = threading.Lock()
        self._kept: dict[int, _Kept] = {}
        self._numbers = 0

    def keep(self, no: int, trace: Trace | BridgeError) -> None:
        """Keep the trace of a case, or why there is none. Raises LimitReached."""
        with self._lock:
            earlier = self._kept.get(no)
            if earlier is not None:
                earlier.times += 1
                return
            size = trace.values.size if isinstance(trace, Trace) else 0
            if self._numbers + size > MAX_NUMBERS or len(self._kept) >= MAX_CASES:
                raise LimitReached(f"signals: more than {MAX_NUMBERS} numbers or {MAX_CASES} cases were not taken")
            self._numbers += size
            self._kept[no] = _Kept(trace)

    def take(self, no: int) -> tuple[Trace | None, int]:
        """Remove and return the trace of a case, and how often one was kept. Raises the error of the case."""
        with self._lock:
            kept = self._kept.get(no)
            if kept is None:
                return None, 0
            trace = kept.trace
            if isinstance(trace, BridgeError):
                raise trace
            self._numbers -= trace.values.size
            # Marks the case, so that a later trace of it is not taken for the first one.
            self._kept[no] = _Kept(InvalidRequest(f"case_no: the signals of case {no} were taken already"))
            return trace, kept.times
