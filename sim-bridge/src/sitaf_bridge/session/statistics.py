"""How often operations were carried out, and how long they took."""

import threading
from collections.abc import Mapping
from dataclasses import dataclass, replace


@dataclass
class Took:
    """Nanoseconds of all operations of one name."""

    count: int = 0
    total_ns: int = 0
    shortest_ns: int = 0


class Statistics:
    """Counts of all sessions of a process. Safe for many threads."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._took: dict[str, Took] = {}

    def add(self, operation: str, nanoseconds: int) -> None:
        """Count one operation."""
        with self._lock:
            took = self._took.setdefault(operation, Took(shortest_ns=nanoseconds))
            took.count += 1
            took.total_ns += nanoseconds
            took.shortest_ns = min(took.shortest_ns, nanoseconds)

    def seen(self) -> Mapping[str, Took]:
        """A copy, in the order of names."""
        with self._lock:
            return {name: replace(took) for name, took in sorted(self._took.items())}
