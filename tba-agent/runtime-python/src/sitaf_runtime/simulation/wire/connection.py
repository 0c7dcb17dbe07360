"""A connection to the robot simulator."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import grpc

from sitaf_runtime.errors import SimulationError
from sitaf_runtime.simulation.wire.operations import OperationSocket
from sitaf_runtime.simulation.wire.service import client
from sitaf_runtime.simulation.wire.sitaf.sim.v1 import simulation_pb2 as pb

CALL_TIMEOUT_S = 60.0
_MAX_MESSAGE_BYTES = 256 << 20
_REJECTED = (
    grpc.StatusCode.INVALID_ARGUMENT,
    grpc.StatusCode.OUT_OF_RANGE,
    grpc.StatusCode.DATA_LOSS,
    grpc.StatusCode.RESOURCE_EXHAUSTED,
    grpc.StatusCode.FAILED_PRECONDITION,
)


class Connection:
    """Makes calls of the simulator's services, and knows when it is lost.

    `target` is the address of the simulator: `127.0.0.1:PORT` or `unix:/absolute/path`.
    """

    def __init__(self, target: str) -> None:
        self._gone: SimulationError | None = None
        self._channel = grpc.insecure_channel(
            target,
            options=[
                ("grpc.enable_http_proxy", 0),
                ("grpc.max_receive_message_length", _MAX_MESSAGE_BYTES),
                ("grpc.max_send_message_length", _MAX_MESSAGE_BYTES),
            ],
        )
        self._target = target
        self._operations: OperationSocket | None = None
        self.control: Any = client(self._channel, pb.DESCRIPTOR, "SimulationControl")
        self.devices: Any = client(self._channel, pb.DESCRIPTOR, "VirtualHardware")

    def use_operation_socket(self) -> None:
        """Run operations over the simulator's socket of operations from now on, unless it cannot be reached."""
        try:
            self._operations = OperationSocket(self._target.removeprefix("unix:") + ".ops")
        except OSError:
            # Its number of connections is limited.
            self._operations = None

    def prepare(self, request: pb.PrepareRequest, timeout: float) -> Any:
        """Prepare a case. Raises grpc.RpcError."""
        return self._operate("prepare", self.control.Prepare, request, timeout)

    def step(self, request: pb.StepSimulationRequest, timeout: float) -> Any:
        """Advance time. Raises grpc.RpcError."""
        return self._operate("step", self.control.StepSimulation, request, timeout)

    def set(self, request: pb.SetParametersRequest, timeout: float) -> Any:
        """Set parameters. Raises grpc.RpcError."""
        return self._operate("set_parameters", self.control.SetParameters, request, timeout)

    def write(self, request: pb.WriteDevicesRequest, timeout: float) -> Any:
        """Command devices. Raises grpc.RpcError."""
        return self._operate("write", self.devices.WriteDevices, request, timeout)

    def _operate(self, name: str, unary: Callable[..., Any], request: Any, timeout: float) -> Any:
        """Run an operation; the answer has its `state`."""
        if self._operations is None:
            return unary(request, timeout=timeout)
        return self._operations.operate(name, request, timeout)

    def ask(self, what: str, call: Callable[..., Any], request: object) -> Any:
        """Make a call. Raises SimulationError, which names what it was for."""
        try:
            return call(request, timeout=CALL_TIMEOUT_S)
        except grpc.RpcError as e:
            raise self.failure(what, e) from None

    def command(self, what: str, call: Callable[..., Any], request: object) -> Any:
        """Make a call with commands. Raises ValueError, an error of the component, when a device rejects one."""
        try:
            return call(request, timeout=CALL_TIMEOUT_S)
        except grpc.RpcError as e:
            code, details = _status(e)
            if code in (grpc.StatusCode.INVALID_ARGUMENT, grpc.StatusCode.OUT_OF_RANGE):
                raise ValueError(details) from None
            raise self.failure(what, e) from None

    def failure(self, what: str, e: grpc.RpcError) -> SimulationError:
        """The error of a call that failed; remembers that the simulator is lost."""
        code, details = _status(e)
        reason = f": {details}" if details else ""
        diverged = code == grpc.StatusCode.DATA_LOSS
        failure = SimulationError(
            f"simulator: {what}: {code.name}{reason}", lost=code not in _REJECTED, diverged=diverged
        )
        if failure.lost:
            self._gone = failure
        return failure

    def require_not_lost(self) -> None:
        """Raise SimulationError when an earlier call found the simulator or the session lost."""
        if self._gone is not None:
            raise SimulationError(f"the simulator is gone: {self._gone}", lost=True)

    def close(self) -> None:
        """Close the connection."""
        if self._operations is not None:
            self._operations.close()
        self._channel.close()


def _status(e: grpc.RpcError) -> tuple[grpc.StatusCode, str]:
    call: Any = e
    return call.code(), call.details() or ""
