"""The devices of one endpoint that are not simulated, paced by the wall clock, and what was measured in each case."""

import math
import threading
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field

from sitaf_bridge.errors import UnreachableValue
from sitaf_bridge.hardware.client import CommandRefused, ProviderClient, ProviderLost
from sitaf_bridge.hardware.replay import Recorded
from sitaf_bridge.world.devices import KINDS, Command, Reading
from sitaf_bridge.world.sensing.faults import dropped
from sitaf_bridge.world.world import World

MAX_CASES = 100_000
MAX_FAULTS = 8
# Waits that are shorter cost more than they give.
MIN_WAIT_NS = 200_000


@dataclass(frozen=True)
class Backend:
    """What serves a device: a provider, also as a shadow, or a recording."""

    device: str
    max_age_s: float
    shadow: bool = False
    recorded: Recorded | None = None
    independent_of: tuple[str, ...] = ()


@dataclass
class Report:
    """What was measured in one case; see TakeHardwareReportResponse."""

    exchanges: int = 0
    total_jitter_ns: int = 0
    max_jitter_ns: int = 0
    missed: int = 0
    readings: int = 0
    max_age_s: float = 0.0
    stale: int = 0
    refused: int = 0
    safe_stops: int = 0
    faults: list[str] = field(default_factory=list)

    def fault(self, reason: str) -> None:
        """Add a fault, each once."""
        if reason not in self.faults and len(self.faults) < MAX_FAULTS:
            self.faults.append(reason)


class LiveHardware:
    """The backends of an endpoint. The reports survive the session, which the component can delete."""

    def __init__(
        self,
        backends: Callable[[World], Mapping[str, Backend]],
        guard: ProviderClient | None,
        clock: Callable[[], int] = time.monotonic_ns,
        sleep: Callable[[float], None] = time.sleep,
    ) -> None:
        self._of_world = backends
        self._backends: Mapping[str, Backend] = {}
        self._guard = guard
        self._real: list[str] = []
        self._driven: list[str] = []
        self._clock = clock
        self._sleep = sleep
        self._timestep_ns = 1
        self._reports: dict[int, Report] = {}
        self._report = Report()
        self._cached_step = -1
        self._cache: dict[str, Reading] = {}
        self._errors: dict[str, float] = {}
        # When step 0 of the current run was, on the clock; None until time advances.
        self._anchor: int | None = None
        self._began_at = 0
        # Guards against a stop by the agent during a case.
        self._lock = threading.Lock()
        self._moving = False
        self._described: Mapping[str, Sequence[str]] = {}

    def attach(self, world: World) -> None:
        """Serve a new session of the endpoint, which always has the same world."""
        if not self._backends:
            self._backends = self._of_world(world)
            self._real = [b.device for b in self._backends.values() if b.recorded is None]
            self._driven = [name for name in self._real if not self._backends[name].shadow]
        self._timestep_ns = world.timestep_ns
        self._hold()
        self.forget()

    def begin(self, no: int) -> None:
        """A case begins; its report continues if there is one, because the component can prepare the world, too."""
        self.stop("the case ended")
        if no not in self._reports and len(self._reports) >= MAX_CASES:
            self._reports.clear()
        self._report = self._reports.setdefault(no, Report())
        self._anchor = None
        self._hold()
        with self._lock:
            self._moving = bool(self._driven)
        self.forget()

    def settled(self) -> None:
        """The call under test follows, whose beginning is not paced."""
        self._anchor = None

    def stop(self, reason: str) -> None:
        """Stop the devices safely, unless they were stopped since a case began."""
        with self._lock:
            moving, self._moving = self._moving, False
        if not moving or self._guard is None:
            return
        try:
            self._guard.stop(self._driven, reason)
            self._report.safe_stops += 1
        except (ProviderLost, CommandRefused) as error:
            self._report.fault(f"{', '.join(self._driven)} could not be stopped: {error}")

    def report(self, no: int) -> Report:
        """End a case and return its report."""
        report = self._reports.get(no, Report())
        if report is self._report:
            self.stop("the case ended")
        return report

    def close(self) -> None:
        """Stop and release the devices."""
        self.stop("the build ended")
        if self._guard is not None:
            self._guard.close()

    def perceived(self, step: int, simulated: Sequence[Reading]) -> Sequence[Reading]:
        """The readings with those of other backends."""
        if step != self._cached_step:
            self._cache.clear()
            self._cached_step = step
        missing = [
            r for r in simulated if r.device.name in self._backends and r.device.name not in self._cache and r.values
        ]
        if missing:
            self._read(step, missing)
        return [self._cache.get(r.device.name, r) if r.values else r for r in simulated]

    def forget(self) -> None:
        """Read the devices again at this step."""
        self._cache.clear()

    def command(self, commands: Sequence[Command]) -> None:
        """Send commands to real devices that are not shadows. Raises UnreachableValue."""
        sent = [(c.device, c.numbers) for c in commands if c.device in self._driven]
        if not sent or self._guard is None:
            return
        try:
            self._guard.command(sent)
        except CommandRefused as error:
            self._report.refused += 1
            raise UnreachableValue(str(error)) from error
        except ProviderLost as error:
            self._report.fault(str(error))

    def set(self, parameters: Mapping[str, float]) -> None:
        """Set the parameters that the providers can set. Raises UnreachableValue."""
        self.forget()
        if self._guard is None or not self._real:
            return
        settable = {name for device in self._driven for name in self._described.get(device, ())}
        parameters = {name: value for name, value in parameters.items() if name in settable}
        if not parameters:
            return
        try:
            self._guard.set(parameters)
        except CommandRefused as error:
            raise UnreachableValue(str(error)) from error
        except ProviderLost as error:
            self._report.fault(str(error))

    def shadows(self) -> Sequence[str]:
        """The devices with a shadow."""
        return [backend.device for backend in self._backends.values() if backend.shadow]

    def shadow_error(self, device: str) -> float:
        """The greatest difference at the last step that was read."""
        return self._errors.get(device, math.nan)

    def begin_run(self, step: int) -> None:
        """Start the clock with the first run after the world was prepared."""
        if self._anchor is None:
            self._anchor = self._clock() - step * self._timestep_ns
        self._began_at = step

    def pace(self, step: int) -> None:
        """Wait for the wall clock."""
        if self._anchor is None:
            return
        wait = self._anchor + step * self._timestep_ns - self._clock()
        if wait > MIN_WAIT_NS:
            self._sleep(wait / 1e9)

    def end_run(self, step: int) -> None:
        """Measure how late a run ended."""
        if self._anchor is None:
            return
        late = max(0, self._clock() - (self._anchor + step * self._timestep_ns))
        report = self._report
        report.exchanges += 1
        report.total_jitter_ns += late
        report.max_jitter_ns = max(report.max_jitter_ns, late)
        if late > (step - self._began_at) * self._timestep_ns:
            report.missed += 1

    def _hold(self) -> None:
        if self._guard is None or not self._real:
            return
        try:
            self._guard.hold(self._real)
            if not self._described:
                self._described = {d.name: list(d.parameters) for d in self._guard.describe().devices}
        except (ProviderLost, CommandRefused) as error:
            self._report.fault(str(error))

    def _read(self, step: int, simulated: Sequence[Reading]) -> None:
        real = {r.device.name: r for r in simulated if self._backends[r.device.name].recorded is None}
        for reading in simulated:
            backend = self._backends[reading.device.name]
            if backend.recorded is not None:
                values = backend.recorded.at(step * self._timestep_ns / 1e9, backend.max_age_s)
                device = reading.device
                self._cache[device.name] = Reading(
                    device, dropped(reading.values, device) if values is None else values
                )
        if not real or self._guard is None:
            return
        began = self._clock()
        try:
            answers = {a.device: a for a in self._guard.read(list(real), {name: r.values for name, r in real.items()})}
        except (ProviderLost, CommandRefused) as error:
            self._report.fault(str(error))
            answers = {}
        way_s = (self._clock() - began) / 1e9
        for name, reading in real.items():
            answer = answers.get(name)
            values = (
                None if answer is None else self._accepted(name, reading, answer.values, answer.age_ns / 1e9 + way_s)
            )
            if answer is not None and answer.fault:
                self._report.fault(f"{name}: {answer.fault}")
                values = None
            self._keep(reading, values)

    def _accepted(
        self, name: str, simulated: Reading, values: Sequence[float], age_s: float
    ) -> tuple[float, ...] | None:
        """The values of a reading; None if it is too old."""
        report, backend = self._report, self._backends[name]
        report.readings += 1
        if len(values) != len(simulated.values):
            return None
        if age_s > backend.max_age_s:
            report.stale += 1
            report.fault(f"{name}: a reading was older than max_age_s: {backend.max_age_s:g}")
            return None
        report.max_age_s = max(report.max_age_s, age_s)
        return KINDS[simulated.device.kind].limited(simulated.device, tuple(values))

    def _keep(self, simulated: Reading, values: tuple[float, ...] | None) -> None:
        device = simulated.device
        read = dropped(simulated.values, device) if values is None else values
        if not self._backends[device.name].shadow:
            self._cache[device.name] = Reading(device, read)
            return
        self._cache[device.name] = simulated
        pairs = zip(read, simulated.values, strict=True)
        self._errors[device.name] = max((0.0 if a == b else abs(a - b) for a, b in pairs), default=0.0)
