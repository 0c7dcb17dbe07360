"""The bulk call PrepareMany: flat arrays in, flat arrays out."""

import os
from collections.abc import Callable

import numpy as np

from sitaf_bridge.errors import InvalidRequest, LimitReached
from sitaf_bridge.server.packing import varint
from sitaf_bridge.wire import simulation_pb2 as pb
from sitaf_bridge.world.driving.many import Cases, prepare_many
from sitaf_bridge.world.world import World

MAX_CASES = 1_000_000
MAX_NUMBERS = 8_000_000
# The tag of the field READINGS: its number, and wire type 2 (packed).
READINGS_TAG = bytes([(pb.PrepareManyResponse.READINGS_FIELD_NUMBER << 3) | 2])


def prepare_many_response(
    world: World, seed: int, request: pb.PrepareManyRequest, is_active: Callable[[], bool]
) -> pb.PrepareManyResponse:
    """Prepare the cases of a request. Raises InvalidRequest, LimitReached, UnreachableValue, Cancelled."""
    names = tuple(request.parameters)
    if request.cases > MAX_CASES:
        raise LimitReached(f"cases: {request.cases}; the limit of one call is {MAX_CASES}")
    if len(request.values) > MAX_NUMBERS:
        raise LimitReached(f"values: {len(request.values)} numbers; the limit of one call is {MAX_NUMBERS}")
    if len(request.values) != request.cases * len(names):
        raise InvalidRequest(
            f"values: {len(request.values)} numbers are not {request.cases} cases of {len(names)} parameters"
        )
    values = np.array(request.values, np.float64).reshape(request.cases, len(names))
    cases = Cases(names, values, request.settle_ns, tuple(request.devices))
    threads = min(request.threads, os.cpu_count() or 1) or os.cpu_count() or 1
    columns, readings, diverged = prepare_many(world, seed, cases, threads, is_active)
    if readings.size > MAX_NUMBERS:
        raise LimitReached(f"the response has {readings.size} numbers; the limit is {MAX_NUMBERS}; request fewer cases")
    # Encoded directly, because appending single numbers would take longer than the simulation.
    packed = readings.astype("<f8", copy=False).tobytes()
    response = pb.PrepareManyResponse.FromString(READINGS_TAG + varint(len(packed)) + packed)
    response.columns.extend(columns)
    response.diverged_cases.extend(diverged)
    return response
