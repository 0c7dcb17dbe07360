"""The hardware guard of one build: a process between a simulator and the providers of real devices.

It runs outside of the sandbox of the simulator and of the component, so that neither can reach a provider. It holds
the devices for the build, refuses commands beyond their envelopes, and stops them when the simulator or the agent ends.
"""

import contextlib
import json
import math
import os
import time
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from sitaf_hardware import Device, DeviceError, Limits, Provider, Reading, serving
from sitaf_hardware.wire import hardware_pb2 as pb

from sitaf_bridge.hardware.client import TIMEOUT_MS, CommandRefused, ProviderClient, ProviderLost
from sitaf_bridge.server.stopping import StopSignal

# The simulator may run as another user; the parent folders restrict the access.
SOCKET_MODE = 0o666
# A device that got no command for longer does not change more at once.
MAX_RATE_S = 0.1
# Seconds between attempts to reach a provider that was lost.
RETRY_S = 0.1


class BadDevices(Exception):
    """The devices cannot be guarded; the message has one line for each problem."""


@dataclass(frozen=True)
class Envelope:
    """The smallest and largest value, and the greatest change per second, of each number of a device's commands."""

    limits: Mapping[str, tuple[float, float]]
    rates: Mapping[str, float]

    @staticmethod
    def of(entry: Mapping[str, Any]) -> "Envelope":
        """Read from JSON."""
        limits = {name: (_number(low, -1), _number(high, 1)) for name, (low, high) in entry.get("limits", {}).items()}
        return Envelope(limits, {name: float(rate) for name, rate in entry.get("rates", {}).items()})


def _number(value: float | None, sign: int) -> float:
    return sign * math.inf if value is None else float(value)


class GuardedDevice(Device):
    """A device of a provider."""

    def __init__(self, name: str, upstream: "Upstream", described: pb.DeviceDescription, envelope: Envelope) -> None:
        self._name = name
        self.upstream = upstream
        self._envelope = envelope
        self.kind = described.kind
        self.fields = {field.name: field.unit for field in described.fields}
        self.parameters = list(described.parameters)
        self.follows_simulation = described.follows_simulation
        self.commands = {number.name: _narrowed(number, envelope) for number in described.commands}
        # The last command of each number and when it was sent; at rest before the first.
        self._last: dict[str, tuple[float, float]] = {}

    def read(self) -> Reading:
        """The reading of the provider; its age includes the way to here."""
        began = time.monotonic()
        simulated = {self._name: self.simulated} if self.follows_simulation else {}
        with _failures():
            (reading,) = self.upstream.held().read([self._name], simulated)
        if reading.fault:
            raise DeviceError(reading.fault)
        return Reading(list(reading.values), began - reading.age_ns / 1e9)

    def check(self, numbers: Mapping[str, float]) -> None:
        """Refuse a command that changes a number too fast."""
        now = time.monotonic()
        for name, rate in self._envelope.rates.items():
            if name not in numbers:
                continue
            before, at = self._last.get(name) or (self._at_rest(name), -math.inf)
            if abs(numbers[name] - before) > rate * min(now - at, MAX_RATE_S) * (1 + 1e-9):
                raise ValueError(
                    f"{name}: {numbers[name]:g} after {before:g} is a change of more than {rate:g} per second"
                )

    def command(self, numbers: Mapping[str, float]) -> None:
        """Send a command within the envelope."""
        with _failures():
            self.upstream.held().command([(self._name, numbers)])
        now = time.monotonic()
        self._last.update({name: (value, now) for name, value in numbers.items()})

    def set(self, parameters: Mapping[str, float]) -> None:
        """Set parameters of the environment."""
        try:
            with _failures():
                self.upstream.held().set(parameters)
        except _RefusedError as error:
            raise ValueError(str(error)) from error

    def stop(self) -> None:
        """Stop the device."""
        self._last.clear()
        with _failures():
            self.upstream.client.stop([self._name], "the hardware guard")

    def _at_rest(self, name: str) -> float:
        """The value of a number before the first command: that of the reading, else 0."""
        if name not in self.fields:
            return 0.0
        return float(self.read().values[list(self.fields).index(name)])


class GuardProvider(Provider):
    """Serves guarded devices; reads those of one provider with one call."""

    def __init__(self, devices: Mapping[str, GuardedDevice], name: str) -> None:
        super().__init__(devices, name)
        self._guarded = devices

    def read_devices(
        self, names: Sequence[str], simulated: Mapping[str, tuple[float, ...]]
    ) -> Sequence[pb.DeviceReading]:
        """The readings of the providers; their age includes the way to here."""
        by_upstream: dict[Upstream, list[str]] = {}
        for name in names:
            by_upstream.setdefault(self._guarded[name].upstream, []).append(name)
        found: dict[str, pb.DeviceReading] = {}
        for upstream, devices in by_upstream.items():
            began = time.monotonic_ns()
            wanted = {name: simulated.get(name, ()) for name in devices if self._guarded[name].follows_simulation}
            try:
                with _failures():
                    readings = upstream.held().read(devices, wanted)
            except DeviceError as error:
                found.update({name: pb.DeviceReading(device=name, fault=str(error)) for name in devices})
                continue
            way_ns = time.monotonic_ns() - began
            for reading in readings:
                reading.age_ns += way_ns
                found[reading.device] = reading
        lost = "the provider gave no reading"
        return [found.get(name) or pb.DeviceReading(device=name, fault=lost) for name in names]


class Upstream:
    """The connection to one provider; a lost one is established again."""

    def __init__(self, address: str, timeout_ms: int) -> None:
        self.client = ProviderClient(address, timeout_ms)
        self.devices: list[str] = []
        self._lost_at = 0.0
        self._lost = ""

    def held(self) -> ProviderClient:
        """The client, which holds the devices. Raises DeviceError."""
        if self._lost and time.monotonic() - self._lost_at < RETRY_S:
            raise DeviceError(self._lost)
        try:
            self.client.hold(self.devices)
        except (ProviderLost, CommandRefused) as error:
            self._lost, self._lost_at = str(error), time.monotonic()
            raise DeviceError(str(error)) from error
        self._lost = ""
        return self.client


class _RefusedError(DeviceError):
    """The provider refused what the guard allowed."""


@contextlib.contextmanager
def _failures() -> Iterator[None]:
    try:
        yield
    except ProviderLost as error:
        raise DeviceError(str(error)) from error
    except CommandRefused as error:
        raise _RefusedError(str(error)) from error


def run(listen: str, file: Path, ending: StopSignal) -> None:
    """Guard the devices of a JSON file until the signal. Raises BadDevices, OSError."""
    with contextlib.suppress(OSError):
        # A heartbeat must not wait for the processes of a build.
        os.setpriority(os.PRIO_PROCESS, 0, -10)
    entries: Mapping[str, Mapping[str, Any]] = json.loads(file.read_text("utf-8"))
    upstreams: dict[str, Upstream] = {}
    try:
        devices = _connected(entries, upstreams)
        with serving(GuardProvider(devices, "sitaf_bridge guard"), listen):
            os.chmod(listen.removeprefix("unix:"), SOCKET_MODE)
            print(f"listening {listen}", flush=True)
            ending.wait()
    finally:
        for upstream in upstreams.values():
            upstream.client.close()


def _connected(entries: Mapping[str, Mapping[str, Any]], upstreams: dict[str, Upstream]) -> Mapping[str, GuardedDevice]:
    problems: list[str] = []
    devices: dict[str, GuardedDevice] = {}
    described: dict[str, Mapping[str, pb.DeviceDescription]] = {}
    for name, entry in entries.items():
        address = str(entry["address"])
        if address not in upstreams:
            upstreams[address] = Upstream(address, int(entry.get("timeout_ms", TIMEOUT_MS)))
            try:
                answer = upstreams[address].client.describe()
                described[address] = {device.name: device for device in answer.devices}
            except (ProviderLost, CommandRefused) as error:
                problems.append(f"{name}: {error}")
        if address not in described:
            continue
        found = described[address].get(name)
        if found is None:
            known = ", ".join(described[address]) or "none"
            problems.append(f"{name}: the provider at {address} has no such device; it has {known}")
            continue
        upstreams[address].devices.append(name)
        devices[name] = GuardedDevice(name, upstreams[address], found, Envelope.of(entry))
    for upstream in upstreams.values():
        if not problems:
            try:
                upstream.client.hold(upstream.devices)
            except (ProviderLost, CommandRefused) as error:
                problems.append(f"{', '.join(upstream.devices)}: {error}")
    if problems:
        raise BadDevices("\n".join(problems))
    return devices


def _narrowed(number: pb.Number, envelope: Envelope) -> Limits:
    low = number.min if number.HasField("min") else -math.inf
    high = number.max if number.HasField("max") else math.inf
    narrow_low, narrow_high = envelope.limits.get(number.name, (-math.inf, math.inf))
    return Limits(number.unit, max(low, narrow_low), min(high, narrow_high))
