"""The service HardwareProvider over devices in this process."""

import contextlib
import math
import queue
import secrets
import threading
import time
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field

import grpc

from sitaf_hardware.device import Device, DeviceError, Reading
from sitaf_hardware.wire import hardware_pb2 as pb
from sitaf_hardware.wire import hardware_pb2_grpc as pb_grpc

MIN_TIMEOUT_MS = 10
MAX_TIMEOUT_MS = 10_000
# After the time limit, for a message that has arrived, but that this process was too busy to take.
GRACE_S = 0.005


@dataclass
class _Served:
    device: Device
    lock: threading.Lock = field(default_factory=threading.Lock)
    hold: str = ""
    stops: int = 0
    last_stop: str = ""


class Provider(pb_grpc.HardwareProviderServicer):
    """Implements the service as specified in hardware.proto."""

    def __init__(self, devices: Mapping[str, Device], name: str = "") -> None:
        self._name = name or "sitaf_hardware"
        self._devices = {device: _Served(served) for device, served in devices.items()}
        # Guards which client holds a device.
        self._holding = threading.Lock()

    def close(self, reason: str) -> None:
        """Stop all devices."""
        self._stop(self._devices, reason)

    def Describe(self, request: pb.DescribeRequest, context: grpc.ServicerContext) -> pb.DescribeResponse:
        """Return the devices."""
        return pb.DescribeResponse(
            devices=[_description(name, served.device) for name, served in self._devices.items()], provider=self._name
        )

    def Hold(
        self, request_iterator: Iterator[pb.HoldRequest], context: grpc.ServicerContext
    ) -> Iterator[pb.HoldResponse]:
        """Reserve devices until the stream ends or its heartbeats stop."""
        first = next(request_iterator, None)
        if first is None:
            return
        if not MIN_TIMEOUT_MS <= first.timeout_ms <= MAX_TIMEOUT_MS:
            context.abort(
                grpc.StatusCode.INVALID_ARGUMENT,
                f"timeout_ms: {first.timeout_ms} is not within {MIN_TIMEOUT_MS} to {MAX_TIMEOUT_MS}",
            )
        names = list(dict.fromkeys(first.devices))
        if not names:
            context.abort(grpc.StatusCode.INVALID_ARGUMENT, "devices: the first message must name devices")
        self._find(names, context)
        hold = secrets.token_hex(8)
        with self._holding:
            taken = [name for name in names if self._devices[name].hold]
            if not taken:
                for name in names:
                    self._devices[name].hold = hold
        if taken:
            context.abort(grpc.StatusCode.RESOURCE_EXHAUSTED, f"devices: another client holds {', '.join(taken)}")
        reason = "the client disconnected"
        try:
            yield pb.HoldResponse(hold=hold)
            beats = _Heartbeats(request_iterator)
            while True:
                heard = beats.wait(first.timeout_ms / 1000)
                if heard is None:
                    reason = f"no heartbeat within {first.timeout_ms} ms"
                    break
                if not heard:
                    break
                yield pb.HoldResponse(hold=hold)
        finally:
            # Also when the client cancelled the stream, which closes this generator.
            self._stop(names, reason)
            with self._holding:
                for name in names:
                    self._devices[name].hold = ""
        if reason != "the client disconnected":
            context.abort(grpc.StatusCode.DEADLINE_EXCEEDED, f"{reason}; {', '.join(names)} stopped")

    def Read(self, request: pb.ReadRequest, context: grpc.ServicerContext) -> pb.ReadResponse:
        """Read devices."""
        names = list(dict.fromkeys(request.devices)) or [n for n, s in self._devices.items() if s.hold == request.hold]
        self._find(names, context)
        self._require_hold(request.hold, names, context)
        simulated = {reading.device: tuple(reading.values) for reading in request.simulated}
        return pb.ReadResponse(readings=self.read_devices(names, simulated))

    def read_devices(
        self, names: Sequence[str], simulated: Mapping[str, tuple[float, ...]]
    ) -> Sequence[pb.DeviceReading]:
        """Read devices that are held, one after the other."""
        return [self._read(name, simulated.get(name, ())) for name in names]

    def Command(self, request: pb.CommandRequest, context: grpc.ServicerContext) -> pb.CommandResponse:
        """Check all commands, then carry them out."""
        names = [command.device for command in request.commands]
        self._find(names, context)
        self._require_hold(request.hold, names, context)
        for command in request.commands:
            served = self._devices[command.device]
            _check(command, served.device, context)
            try:
                with served.lock:
                    served.device.check(dict(command.numbers))
            except ValueError as error:
                context.abort(grpc.StatusCode.OUT_OF_RANGE, f"commands: {command.device}.{error}")
            except (DeviceError, OSError) as error:
                context.abort(grpc.StatusCode.UNAVAILABLE, f"{command.device}: {error}")
        for command in request.commands:
            served = self._devices[command.device]
            try:
                with served.lock:
                    # The hold may have ended, and the device been stopped, while this call waited.
                    if served.hold != request.hold:
                        raise DeviceError("is no longer held")
                    served.device.command(dict(command.numbers))
            except (DeviceError, OSError) as error:
                context.abort(grpc.StatusCode.UNAVAILABLE, f"{command.device}: {error}")
        return pb.CommandResponse()

    def Set(self, request: pb.SetRequest, context: grpc.ServicerContext) -> pb.SetResponse:
        """Set parameters of the environment."""
        held = [
            (name, served) for name, served in self._devices.items() if request.hold and served.hold == request.hold
        ]
        if not held:
            context.abort(grpc.StatusCode.FAILED_PRECONDITION, "hold: is not valid")
        known = {parameter for _, served in held for parameter in served.device.parameters}
        for name, value in request.parameters.items():
            if name not in known:
                context.abort(
                    grpc.StatusCode.INVALID_ARGUMENT,
                    f"parameters: {name!r} cannot be set; {', '.join(sorted(known)) or 'none'} can",
                )
            if not math.isfinite(value):
                context.abort(grpc.StatusCode.INVALID_ARGUMENT, f"parameters: {name}: {value} is not a finite number")
        for name, served in held:
            wanted = {p: v for p, v in request.parameters.items() if p in served.device.parameters}
            if not wanted:
                continue
            try:
                with served.lock:
                    served.device.set(wanted)
            except ValueError as error:
                context.abort(grpc.StatusCode.OUT_OF_RANGE, f"{name}: {error}")
            except (DeviceError, OSError) as error:
                context.abort(grpc.StatusCode.UNAVAILABLE, f"{name}: {error}")
        return pb.SetResponse()

    def CheckHealth(self, request: pb.CheckHealthRequest, context: grpc.ServicerContext) -> pb.CheckHealthResponse:
        """Return whether devices work."""
        names = list(request.devices) or list(self._devices)
        self._find(names, context)
        return pb.CheckHealthResponse(devices=[self._health(name) for name in names])

    def StopSafely(self, request: pb.StopSafelyRequest, context: grpc.ServicerContext) -> pb.StopSafelyResponse:
        """Stop devices."""
        names = list(request.devices) or list(self._devices)
        self._find(names, context)
        faults = self._stop(names, request.reason or "a client asked for it")
        if faults:
            context.abort(grpc.StatusCode.UNAVAILABLE, "; ".join(faults))
        return pb.StopSafelyResponse()

    def _find(self, names: Iterable[str], context: grpc.ServicerContext) -> None:
        for name in names:
            if name not in self._devices:
                known = ", ".join(self._devices) or "none"
                context.abort(grpc.StatusCode.NOT_FOUND, f"devices: no device {name!r}; devices: {known}")

    def _require_hold(self, hold: str, names: Iterable[str], context: grpc.ServicerContext) -> None:
        other = [name for name in names if not hold or self._devices[name].hold != hold]
        if other:
            context.abort(grpc.StatusCode.FAILED_PRECONDITION, f"hold: does not hold {', '.join(other)}")

    def _read(self, name: str, simulated: tuple[float, ...]) -> pb.DeviceReading:
        served = self._devices[name]
        try:
            with served.lock:
                served.device.simulated = simulated
                found = served.device.read()
            reading = found if isinstance(found, Reading) else Reading(found)
            values = [float(value) for value in reading.values]
            if len(values) != len(served.device.fields):
                raise DeviceError(f"gave {len(values)} numbers instead of {len(served.device.fields)}")
            age_ns = max(0, round((time.monotonic() - reading.taken) * 1e9))
            return pb.DeviceReading(device=name, values=values, age_ns=age_ns)
        except (DeviceError, OSError) as error:
            return pb.DeviceReading(device=name, fault=str(error) or type(error).__name__)

    def _health(self, name: str) -> pb.DeviceHealth:
        served = self._devices[name]
        try:
            with served.lock:
                fault = served.device.fault()
        except (DeviceError, OSError) as error:
            fault = str(error) or type(error).__name__
        return pb.DeviceHealth(
            device=name, fault=fault, safe_stops=served.stops, last_stop=served.last_stop, held=bool(served.hold)
        )

    def _stop(self, names: Iterable[str], reason: str) -> list[str]:
        """Stop devices; returns the faults of those that could not be stopped."""
        faults: list[str] = []
        for name in names:
            served = self._devices[name]
            served.last_stop = reason
            served.stops += 1
            try:
                with served.lock:
                    served.device.stop()
            except (DeviceError, OSError) as error:
                faults.append(f"{name}: {error}")
        return faults


class _Heartbeats:
    """Waits for the messages of a stream, with a time limit, which iterators of gRPC do not have."""

    def __init__(self, requests: Iterator[pb.HoldRequest]) -> None:
        self._heard: queue.SimpleQueue[bool] = queue.SimpleQueue()
        threading.Thread(target=self._listen, args=(requests,), name="heartbeats", daemon=True).start()

    def _listen(self, requests: Iterator[pb.HoldRequest]) -> None:
        with contextlib.suppress(Exception):  # the stream was cancelled
            for _ in requests:
                self._heard.put(True)
        self._heard.put(False)

    def wait(self, limit_s: float) -> bool | None:
        """Whether a message arrived, or the stream ended (False); None after the time limit."""
        for wait_s in (limit_s, GRACE_S):
            with contextlib.suppress(queue.Empty):
                return self._heard.get(timeout=wait_s)
        return None


def _description(name: str, device: Device) -> pb.DeviceDescription:
    commands = [
        pb.Number(
            name=number,
            unit=limits.unit,
            min=limits.low if math.isfinite(limits.low) else None,
            max=limits.high if math.isfinite(limits.high) else None,
        )
        for number, limits in device.commands.items()
    ]
    return pb.DeviceDescription(
        name=name,
        kind=device.kind,
        fields=[pb.Number(name=number, unit=unit) for number, unit in device.fields.items()],
        commands=commands,
        parameters=device.parameters,
        follows_simulation=device.follows_simulation,
    )


def _check(command: pb.DeviceCommand, device: Device, context: grpc.ServicerContext) -> None:
    if not command.numbers:
        context.abort(grpc.StatusCode.INVALID_ARGUMENT, f"commands: the command to {command.device} is empty")
    for name, value in command.numbers.items():
        limits = device.commands.get(name)
        if limits is None:
            known = ", ".join(device.commands) or "no numbers"
            context.abort(
                grpc.StatusCode.INVALID_ARGUMENT, f"commands: {command.device} has no number {name!r}; it takes {known}"
            )
        elif not math.isfinite(value):
            context.abort(
                grpc.StatusCode.INVALID_ARGUMENT, f"commands: {command.device}.{name}: {value} is not a finite number"
            )
        elif not limits.low <= value <= limits.high:
            context.abort(
                grpc.StatusCode.OUT_OF_RANGE,
                f"commands: {command.device}.{name}: {value:g} is not within {limits.low:g} to {limits.high:g}",
            )
