"""Counts operations and their durations."""

import threading
from collections.abc import Mapping
from dataclasses import dataclass, replace


@dataclass
class Elapsed:
    """Total duration in nanoseconds and number of the operations of one name."""

    count: int = 0
    total_ns: int = 0
    shortest_ns: int = 0


class Statistics:
    """Counters of all sessions of a process. Thread-safe."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._took: dict[str, Elapsed] = {}

    def add(self, operation: str, nanoseconds: int) -> None:
        """Count one operation."""
        with self._lock:
            took = self._took.setdefault(operation, Elapsed(shortest_ns=nanoseconds))
            took.count += 1
            took.total_ns += nanoseconds
            took.shortest_ns = min(took.shortest_ns, nanoseconds)

    def seen(self) -> Mapping[str, Elapsed]:
        """A copy, sorted by name."""
        with self._lock:
            return {name: replace(took) for name, took in sorted(self._took.items())}
