"""Prepares the following cases in bulk as long as components only read their devices."""

from __future__ import annotations

import struct
from collections.abc import Callable, Mapping, Sequence

from sitaf_runtime.errors import CaseDataError
from sitaf_runtime.simulation.frozen import FrozenWorld, Layout
from sitaf_runtime.simulation.wire.sitaf.sim.v1 import simulation_pb2 as pb
from sitaf_runtime.suite.kinds import FLOAT64
from sitaf_runtime.suite.test_case import TestCase

# The first batch is small, so that the first case starts soon.
_FIRST_BATCH_SIZE = 32
_MAX_BATCH_SIZE = 4096
_MAX_NUMBERS = 1_000_000

Values = tuple[float, ...]


class Preparation:
    """Prepares the worlds of several cases in one call.

    The session itself prepares a case, with the same readings, when the batch does not contain its values, its
    simulation diverged or was rejected, or after `stop`.
    """

    def __init__(
        self,
        layout: Layout,
        upcoming: Callable[[int], Sequence[TestCase]],
        ask: Callable[[pb.PrepareManyRequest], pb.PrepareManyResponse | None],
    ) -> None:
        self._layout = layout
        self._upcoming = upcoming
        self._ask = ask
        self._known: dict[bytes, Sequence[float]] = {}
        self._size = _FIRST_BATCH_SIZE
        self._stopped = False
        self._cases_to_prepare_separately = 0

    def stop(self) -> None:
        """Stop preparing in bulk, because the component commands its hardware or waits."""
        self._stopped = True
        self._known = {}

    def world(self, parameters: Mapping[str, float], settle_ns: int, time_ns: int) -> FrozenWorld | None:
        """The prepared world of the current case; None when the session must prepare it."""
        if self._stopped or not parameters:
            return None
        key = _key(parameters.values())
        numbers = self._known.get(key)
        if numbers is None:
            if self._cases_to_prepare_separately > 0:
                self._cases_to_prepare_separately -= 1
                return None
            self._prepare_batch(list(parameters), tuple(parameters.values()), settle_ns)
            numbers = self._known.get(key)
        return None if numbers is None else FrozenWorld(time_ns, numbers)

    def _prepare_batch(self, names: list[str], current: Values, settle_ns: int) -> None:
        self._known = {}
        rows = self._rows(names, current)
        request = pb.PrepareManyRequest(parameters=names, cases=len(rows), settle_ns=settle_ns)
        for row in rows:
            request.values.extend(row)
        response = self._ask(request)
        if response is None:
            # One case was rejected. Preparing each case separately reports which one.
            self._cases_to_prepare_separately = len(rows)
            return
        try:
            order = self._layout.order_of(response.columns)
        except ValueError:
            self.stop()
            return
        width = len(response.columns)
        readings = list(response.readings)
        diverged = set(response.diverged_cases)
        for i, row in enumerate(rows):
            numbers = readings[i * width : (i + 1) * width]
            if i not in diverged:
                self._known[_key(row)] = numbers if order is None else [numbers[at] for at in order]
        self._size = min(self._size * 4, _MAX_BATCH_SIZE)

    def _rows(self, names: list[str], current: Values) -> list[Values]:
        """The values of the current case and of the following cases, each combination once."""
        rows = {_key(current): current}
        width = max(1, len(self._layout.columns), len(names))
        for case in self._upcoming(min(self._size, max(1, _MAX_NUMBERS // width))):
            try:
                row = tuple(case.read(name, FLOAT64) for name in names)
            except CaseDataError:
                break
            rows.setdefault(_key(row), row)
        return list(rows.values())


def _key(values: object) -> bytes:
    """Compares values by their bits, so 0.0 and -0.0 differ."""
    row = tuple(values)  # pyright: ignore[reportArgumentType]
    return struct.pack(f"<{len(row)}d", *row)
