"""Prepares many cases, each from a clean reset, on several threads."""

import math
import threading
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sitaf_bridge.errors import Cancelled, Diverged, InvalidRequest, UnreachableValue
from sitaf_bridge.world.devices import KINDS, DeviceDeclaration, Reading
from sitaf_bridge.world.driving.batch import BatchRun, can_batch
from sitaf_bridge.world.driving.checking import check_names, check_values, steps_in
from sitaf_bridge.world.driving.simulation import Simulation
from sitaf_bridge.world.sensing.fault_names import FaultName, check_fault_name, check_fault_value, is_fault
from sitaf_bridge.world.sensing.fault_schedule import FaultSchedule
from sitaf_bridge.world.sensing.sensing import Sensing
from sitaf_bridge.world.state import WorldState
from sitaf_bridge.world.world import World

# With fewer cases, the setup of a batch (some milliseconds) does not pay off.
MIN_BATCH_SIZE = 32
# Cases per batch: enough to keep the threads busy, few enough for the caches.
CHUNK = 2_000


@dataclass(frozen=True)
class Cases:
    """One row of `values` per case, one column per parameter; `devices` to read, none for all."""

    names: tuple[str, ...]
    values: NDArray[np.float64]
    settle_ns: int
    devices: tuple[str, ...]


@dataclass(frozen=True)
class _Job:
    world: World
    seed: int
    cases: Cases
    devices: tuple[DeviceDeclaration, ...]
    columns: tuple[str, ...]
    readings: NDArray[np.float64]


def prepare_many(
    world: World, seed: int, cases: Cases, threads: int, is_active: Callable[[], bool]
) -> tuple[tuple[str, ...], NDArray[np.float64], list[int]]:
    """Return the names of the columns, the readings by row, and the cases that diverged.

    Each row is bit-identical to Simulation.prepare. Raises InvalidRequest, LimitReached, UnreachableValue, Cancelled.
    """
    simulation = Simulation(world, seed)
    steps = steps_in(world, cases.settle_ns, "settle_ns")
    _check(world, cases)
    devices = _devices(world, cases.devices)
    columns = tuple(f"{d.name}.{field}" for d in devices for field in KINDS[d.kind].fields(d))
    columns += tuple(world.observations)
    count = len(cases.values)
    job = _Job(world, seed, cases, devices, columns, np.empty((count, len(columns))))
    diverged: list[int] = []
    left: Sequence[int] = range(count)
    if count >= MIN_BATCH_SIZE and can_batch(world, devices):
        run = BatchRun(world, devices, cases.names, min(CHUNK, count), threads)
        odd: list[int] = []
        for first in range(0, count, CHUNK):
            if not is_active():
                raise Cancelled("the caller disconnected")
            rows = slice(first, min(first + CHUNK, count))
            strange = run.prepare(cases.values[rows], steps, job.readings[rows])
            odd += [first + index for index in strange]
        left = sorted({*odd, *_add_faults(job, steps)})
    if left:
        diverged = _one_by_one(job, left, threads, simulation, is_active)
    return columns, job.readings, diverged


def _add_faults(job: _Job, steps: int) -> list[int]:
    """Add the faults to the readings of a batch; returns the rows whose past must be simulated."""
    columns = [i for i, name in enumerate(job.cases.names) if is_fault(name)]
    if not columns:
        return []
    names = [job.cases.names[i] for i in columns]
    schedules: dict[tuple[float, ...], FaultSchedule] = {}
    left: list[int] = []
    sensing = Sensing(job.world, job.seed)
    for row, given in enumerate(map(tuple, job.cases.values[:, columns].tolist())):
        schedule = schedules.get(given)
        if schedule is None:
            values = dict(zip(names, given, strict=True))
            schedule = schedules[given] = FaultSchedule().updated(job.world, values, names, steps)
        if not schedule.of_readings:
            continue
        if steps and schedule.needs_past(0):
            left.append(row)
            continue
        sensing.follow(schedule)
        numbers = job.readings[row]
        # Each device of a batch has one number.
        readings = [Reading(device, (numbers.item(i),)) for i, device in enumerate(job.devices)]
        for i, reading in enumerate(sensing.faulty(steps, readings)):
            numbers[i] = reading.values[0]
        sensing.follow(FaultSchedule())
    return left


def _one_by_one(
    job: _Job, rows: Sequence[int], threads: int, first: Simulation, is_active: Callable[[], bool]
) -> list[int]:
    """Prepare rows in separate simulations, one per thread; returns those that diverged."""
    threads = max(1, min(threads, len(rows)))
    simulations = [first, *(Simulation(job.world, job.seed) for _ in range(threads - 1))]
    stop = threading.Event()

    def work(index: int) -> list[int]:
        diverged: list[int] = []
        for row in rows[index::threads]:
            if stop.is_set() or not is_active():
                stop.set()
                raise Cancelled("the caller disconnected")
            try:
                if not _prepare(job, simulations[index], row, is_active):
                    diverged.append(row)
            except Exception:
                stop.set()
                raise
        return diverged

    if threads == 1:
        return work(0)
    with ThreadPoolExecutor(threads) as pool:
        futures = [pool.submit(work, index) for index in range(threads)]
    errors = [error for future in futures if (error := future.exception()) is not None]
    if errors:
        raise next((error for error in errors if not isinstance(error, Cancelled)), errors[0])
    return sorted(row for future in futures for row in future.result())


def _prepare(job: _Job, simulation: Simulation, row: int, is_active: Callable[[], bool]) -> bool:
    values = dict(zip(job.cases.names, job.cases.values[row].tolist(), strict=True))
    try:
        state = simulation.prepare(values, job.cases.settle_ns, is_active)
    except Diverged:
        job.readings[row] = np.nan
        return False
    except UnreachableValue as error:
        raise UnreachableValue(f"case {row}: {error}") from error
    job.readings[row] = _numbers(job, state)
    return True


def _numbers(job: _Job, state: WorldState) -> list[float]:
    by_name = {reading.device.name: reading.values for reading in state.readings}
    return [value for d in job.devices for value in by_name[d.name]] + list(state.observations.values())


def _devices(world: World, names: Sequence[str]) -> tuple[DeviceDeclaration, ...]:
    devices = world.description.devices
    if not names:
        return tuple(d for d in devices.values() if not KINDS[d.kind].image)
    for name in names:
        if name not in devices:
            raise InvalidRequest(f"devices: no device {name!r}; devices of this world: {', '.join(devices) or 'none'}")
        if KINDS[devices[name].kind].image:
            raise InvalidRequest(f"devices: {name} is a camera, which is read by ReadDevices")
    return tuple(devices[name] for name in dict.fromkeys(names))


def _check(world: World, cases: Cases) -> None:
    if len(set(cases.names)) != len(cases.names):
        raise InvalidRequest("parameters: a name is given twice")
    check_names(world, cases.names)
    parameters = [(i, world.description.parameters[n]) for i, n in enumerate(cases.names) if not is_fault(n)]
    places = [i for i, _ in parameters]
    low, high = np.array([p.low for _, p in parameters]), np.array([p.high for _, p in parameters])
    numbers = cases.values[:, places]
    with np.errstate(invalid="ignore"):
        bad = ~((numbers >= low) & (numbers <= high)).all(axis=1)
    for i, name in enumerate(cases.names):
        if is_fault(name):
            fault = check_fault_name(name, world.description)
            wrong = [value for value in set(cases.values[:, i].tolist()) if not _fits(name, fault, value)]
            bad |= np.isin(cases.values[:, i], wrong) | np.isnan(cases.values[:, i])
    if bad.any():
        row = int(np.flatnonzero(bad)[0])
        values = dict(zip(cases.names, cases.values[row].tolist(), strict=True))
        try:
            check_values(world, values)
        except (InvalidRequest, UnreachableValue) as error:
            raise type(error)(f"case {row}: {error}") from error


def _fits(name: str, fault: FaultName, value: float) -> bool:
    try:
        check_fault_value(name, fault, value)
    except UnreachableValue:
        return False
    return math.isfinite(value)
