"""A client of a hardware provider, which holds its devices while it is open."""

import contextlib
import threading
from collections.abc import Iterator, Mapping, Sequence

import grpc
from sitaf_hardware.wire import hardware_pb2 as pb
from sitaf_hardware.wire import hardware_pb2_grpc as pb_grpc

# The devices stop when no heartbeat arrives for this time.
TIMEOUT_MS = 90
HEARTBEAT_S = 0.015
# Seconds for one call; a device that takes longer does not answer.
CALL_S = 1.0
SETTING_S = 30.0
OPTIONS = (
    ("grpc.enable_http_proxy", 0),
    ("grpc.initial_reconnect_backoff_ms", 50),
    ("grpc.max_reconnect_backoff_ms", 200),
)


class ProviderLost(Exception):
    """The provider does not answer, or the hold has ended; the message says which."""


class CommandRefused(Exception):
    """A command or a parameter is beyond the limits of its device."""


class ProviderClient:
    """One provider. Thread-safe. Raises ProviderLost in each method unless it says otherwise."""

    def __init__(self, address: str, timeout_ms: int = TIMEOUT_MS) -> None:
        self.address = address
        self._timeout_ms = timeout_ms
        self._channel = grpc.insecure_channel(address, options=OPTIONS)
        self._stub = pb_grpc.HardwareProviderStub(self._channel)
        self._lock = threading.Lock()
        self._hold: _Hold | None = None

    def describe(self) -> pb.DescribeResponse:
        """The devices."""
        with _calls(self.address):
            return self._stub.Describe(pb.DescribeRequest(), timeout=5, wait_for_ready=False)

    def hold(self, devices: Sequence[str]) -> None:
        """Hold devices, unless they are held; a lost hold is replaced."""
        with self._lock:
            if self._hold is not None and not self._hold.ended:
                return
            if self._hold is not None:
                self._hold.close()
            self._hold = None
            self._hold = _Hold(self._stub, self.address, devices, self._timeout_ms)

    def read(self, devices: Sequence[str], simulated: Mapping[str, Sequence[float]]) -> Sequence[pb.DeviceReading]:
        """The readings of held devices."""
        request = pb.ReadRequest(
            hold=self._held(),
            devices=devices,
            simulated=[pb.SimulatedReading(device=name, values=values) for name, values in simulated.items()],
        )
        with _calls(self.address):
            return self._stub.Read(request, timeout=CALL_S).readings

    def command(self, commands: Sequence[tuple[str, Mapping[str, float]]]) -> None:
        """Command held devices. Raises CommandRefused."""
        messages = [pb.DeviceCommand(device=device, numbers=numbers) for device, numbers in commands]
        with _calls(self.address):
            self._stub.Command(pb.CommandRequest(hold=self._held(), commands=messages), timeout=CALL_S)

    def set(self, parameters: Mapping[str, float]) -> None:
        """Set parameters of the environment. Raises CommandRefused."""
        with _calls(self.address):
            self._stub.Set(pb.SetRequest(hold=self._held(), parameters=parameters), timeout=SETTING_S)

    def stop(self, devices: Sequence[str], reason: str) -> None:
        """Stop devices safely."""
        with _calls(self.address):
            self._stub.StopSafely(pb.StopSafelyRequest(devices=devices, reason=reason), timeout=CALL_S)

    def health(self) -> Sequence[pb.DeviceHealth]:
        """The health of all devices."""
        with _calls(self.address):
            return self._stub.CheckHealth(pb.CheckHealthRequest(), timeout=CALL_S).devices

    def close(self) -> None:
        """Release the devices, which stops them."""
        with self._lock:
            if self._hold is not None:
                self._hold.close()
            self._hold = None
        self._channel.close()

    def _held(self) -> str:
        hold = self._hold
        if hold is None:
            raise ProviderLost(f"the devices at {self.address} are not held")
        if hold.ended:
            raise ProviderLost(hold.ended)
        return hold.identity


class _Hold:
    """A stream that holds devices; `ended` says why it does not any more."""

    def __init__(
        self, stub: pb_grpc.HardwareProviderStub, address: str, devices: Sequence[str], timeout_ms: int
    ) -> None:
        self.ended = ""
        self._timeout_ms = timeout_ms
        self._address = address
        self._closed = threading.Event()
        self._call = stub.Hold(self._messages(devices))
        with _calls(address):
            self.identity: str = next(self._call).hold
        threading.Thread(target=self._listen, name="hold", daemon=True).start()

    def _messages(self, devices: Sequence[str]) -> Iterator[pb.HoldRequest]:
        yield pb.HoldRequest(devices=devices, timeout_ms=self._timeout_ms)
        while not self._closed.wait(HEARTBEAT_S):
            yield pb.HoldRequest()

    def _listen(self) -> None:
        try:
            for _ in self._call:
                pass
            self.ended = self.ended or f"the provider at {self._address} ended"
        except grpc.RpcError as error:
            self.ended = self.ended or f"the provider at {self._address}: {_details(error)}"
        self._closed.set()

    def close(self) -> None:
        self.ended = self.ended or "the devices were released"
        self._closed.set()
        self._call.cancel()


@contextlib.contextmanager
def _calls(address: str) -> Iterator[None]:
    try:
        yield
    except StopIteration:
        raise ProviderLost(f"the provider at {address} ended the call") from None
    except grpc.RpcError as error:
        if error.code() in (grpc.StatusCode.OUT_OF_RANGE, grpc.StatusCode.INVALID_ARGUMENT):
            raise CommandRefused(error.details() or "") from error
        raise ProviderLost(f"the provider at {address} does not answer: {_details(error)}") from error


def _details(error: grpc.RpcError) -> str:
    return f"{error.code().name}: {error.details()}"
