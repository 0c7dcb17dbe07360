"""When the inputs of a case are published."""

from __future__ import annotations

import heapq
import itertools
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field

from sitaf_runtime.suite.kinds import BOOLEAN, FLOAT64

_NANOS = 1_000_000_000
_MAX_RATE_HZ = 100_000.0


@dataclass(frozen=True, slots=True)
class Publishing:
    """How one input is published; times are in nanoseconds after the call, `None` for no end."""

    wanted: bool = True
    rate_hz: float = 0.0
    at_ns: int = 0
    lasting_ns: int | None = None

    @classmethod
    def of(cls, values: Mapping[str, str], name: str) -> Publishing:
        """Read `publish.NAME` and its parts from the values of a case. Raises ValueError."""
        prefix = f"publish.{name}"
        rate = FLOAT64.parse(values.get(f"{prefix}.rate_hz", "0"))
        at = FLOAT64.parse(values.get(f"{prefix}.at", "0"))
        lasting = FLOAT64.parse(values[f"{prefix}.for"]) if f"{prefix}.for" in values else None
        if not 0 <= rate <= _MAX_RATE_HZ or not 0 <= at < float("inf") or (lasting is not None and not lasting >= 0):
            raise ValueError(
                f"{prefix}: rate_hz must be 0 to {_MAX_RATE_HZ:g}, and at and for must be finite and not negative"
            )
        return cls(
            BOOLEAN.parse(values.get(prefix, "true")),
            rate,
            round(at * _NANOS),
            None if lasting is None or lasting == float("inf") else round(lasting * _NANOS),
        )

    def times_ns(self, call_ns: int) -> Iterator[int]:
        """The times of publication."""
        if not self.wanted:
            return
        yield call_ns + self.at_ns
        if self.rate_hz == 0:
            return
        for number in itertools.count(1):
            after = round(number * _NANOS / self.rate_hz)
            if self.lasting_ns is not None and after >= self.lasting_ns:
                return
            yield call_ns + self.at_ns + after


@dataclass(slots=True)
class Schedule:
    """The publications that are still to come, in the order of time, then of the inputs."""

    _heap: list[tuple[int, int, Iterator[int]]] = field(default_factory=list)

    def add(self, order: int, times: Iterator[int]) -> None:
        """Add an input, `order` being its place in the activity."""
        first = next(times, None)
        if first is not None:
            heapq.heappush(self._heap, (first, order, times))

    def cancel(self, order: int) -> None:
        """Drop what is still to come of an input."""
        self._heap = [entry for entry in self._heap if entry[1] != order]
        heapq.heapify(self._heap)

    def next_ns(self) -> int | None:
        """The time of the next publication; None for never."""
        return self._heap[0][0] if self._heap else None

    def due(self, time_ns: int) -> Iterator[int]:
        """The inputs to publish up to and including a time."""
        while self._heap and self._heap[0][0] <= time_ns:
            _, order, times = heapq.heappop(self._heap)
            yield order
            self.add(order, times)
