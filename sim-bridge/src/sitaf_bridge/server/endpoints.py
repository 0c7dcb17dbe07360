"""Access of test applications to the bridge of one build: sockets with one session and one world each.

A component under test runs in the process of its test application and can make the same calls. Its endpoint restricts
these calls to its own session.
"""

import importlib
import os
import re
import threading
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING

import grpc

from sitaf_bridge.errors import Forbidden, InvalidRequest, NoSuchEndpoint, NoSuchSession, Unavailable
from sitaf_bridge.server.control import SimulationControl
from sitaf_bridge.server.hardware import VirtualHardware
from sitaf_bridge.server.operation_socket import OperationSocket, path_of_operations
from sitaf_bridge.server.status import answering
from sitaf_bridge.server.wire import source_of
from sitaf_bridge.session.registry import Registry
from sitaf_bridge.session.signals import SignalOrder, SignalStore
from sitaf_bridge.wire import administration_pb2 as pb
from sitaf_bridge.wire import administration_pb2_grpc as pb_grpc
from sitaf_bridge.wire import simulation_pb2_grpc
from sitaf_bridge.world.catalog import Catalog
from sitaf_bridge.world.description.source import WorldSource
from sitaf_bridge.world.driving.signals import Trace
from sitaf_bridge.world.state import WorldState
from sitaf_bridge.world.world import World

if TYPE_CHECKING:
    from sitaf_bridge.hardware.live import LiveHardware

MAX_MESSAGE_BYTES = 64 * 1024 * 1024
SERVER_OPTIONS = (
    ("grpc.max_receive_message_length", MAX_MESSAGE_BYTES),
    # Two bridges on one port would receive each other's calls.
    ("grpc.so_reuseport", 0),
)
# The test application makes one call at a time, its component one per thread.
MAX_CALLS = 32
# One for the test application, and some for clients that a component opens.
MAX_CONNECTIONS = 8
MAX_ENDPOINTS = 64
NAME = re.compile(r"[A-Za-z0-9]{1,16}")
# Seconds for running calls to end when their endpoint is closed.
GRACE_S = 0.5
# The test application may run as another user; the parent folders restrict the access.
SOCKET_MODE = 0o666


class OneWorld(Catalog):
    """Offers the worlds of one set of files from another catalog and rejects all others."""

    def __init__(self, catalog: Catalog, digest: str) -> None:
        super().__init__()
        self._catalog = catalog
        self._digest = digest

    def world(self, source: WorldSource) -> World:
        """Return the world of a source. Raises Forbidden for another one."""
        if source.digest != self._digest:
            raise Forbidden("world: this endpoint offers the world of its build only")
        return self._catalog.world(source)


class Endpoint:
    """A socket with its own server, registry and threads."""

    def __init__(
        self,
        path: Path,
        catalog: Catalog,
        lease_s: float,
        threads: int,
        *,
        order: SignalOrder | None = None,
        hardware: "LiveHardware | None" = None,
    ) -> None:
        self.hardware = hardware
        self.signals = SignalStore(order) if order is not None else None
        self.target = f"unix:{path}"
        # Every change of a simulation has a state of its own.
        self._shown: WorldState | None = None
        self._version = 0
        self.sessions = Registry(default_lease_s=lease_s, max_sessions=1)
        self._pool = ThreadPoolExecutor(threads, thread_name_prefix="call")
        self._server = grpc.server(self._pool, options=SERVER_OPTIONS, maximum_concurrent_rpcs=MAX_CALLS)
        operations = path_of_operations(path)
        control = SimulationControl(
            catalog, self.sessions, self.signals, hardware, operation_socket=operations is not None
        )
        virtual = VirtualHardware(self.sessions, threads // 2)
        simulation_pb2_grpc.add_SimulationControlServicer_to_server(control, self._server)
        simulation_pb2_grpc.add_VirtualHardwareServicer_to_server(virtual, self._server)
        self._server.add_insecure_port(self.target)
        os.chmod(path, SOCKET_MODE)
        self._operations = (
            None if operations is None else OperationSocket(operations, control.operated, MAX_CONNECTIONS, SOCKET_MODE)
        )
        self._server.start()

    def show_motion(self, known: int) -> tuple[bytes, int]:
        """The motion of the session so far as GLB, and the version of its state; b"" if it is the known one.

        Raises NoSuchSession, WrongState, LimitReached.
        """
        session = self.sessions.newest()
        if session is None:
            raise NoSuchSession("the endpoint has no session")
        with session.simulation() as simulation:
            if simulation.state is not self._shown:
                self._shown = simulation.state
                self._version += 1
            return b"" if known == self._version else simulation.show_motion(), self._version

    def close(self) -> bool:
        """Close the session; return whether all calls have ended."""
        if self.hardware is not None:
            self.hardware.close()
        stopped = self._server.stop(0)
        idle = self._operations is None or self._operations.close(GRACE_S)
        self.sessions.close()
        self._pool.shutdown(wait=False, cancel_futures=True)
        return stopped.wait(GRACE_S) and idle


class Endpoints:
    """Open endpoints by name. Thread-safe."""

    def __init__(self, folder: Path, catalog: Catalog, lease_s: float, threads: int) -> None:
        self._folder = folder.absolute()
        self._catalog = catalog
        self._lease_s = lease_s
        self._threads = max(2, threads)
        self._lock = threading.Lock()
        self._open: dict[str, Endpoint] = {}

    def open(
        self, name: str, digest: str, order: SignalOrder | None = None, hardware: "LiveHardware | None" = None
    ) -> str:
        """Open an endpoint and return its target. Raises InvalidRequest."""
        if not NAME.fullmatch(name):
            raise InvalidRequest(f"name: {name!r} is not 1 to 16 letters and digits")
        with self._lock:
            if name in self._open:
                raise InvalidRequest(f"name: the endpoint {name} is open already")
            if len(self._open) >= MAX_ENDPOINTS:
                raise InvalidRequest(f"name: {MAX_ENDPOINTS} endpoints are open, which is the limit; close one first")
            world = OneWorld(self._catalog, digest)
            self._open[name] = Endpoint(
                self._folder / name, world, self._lease_s, self._threads, order=order, hardware=hardware
            )
            return self._open[name].target

    def check(self, source: WorldSource) -> World:
        """The world of a source. Raises BadWorld."""
        return self._catalog.world(source)

    def hardware(self, name: str) -> "LiveHardware | None":
        """The devices of an endpoint that are not simulated. Raises NoSuchEndpoint."""
        return self._named(name).hardware

    def show_motion(self, name: str, known: int) -> tuple[bytes, int]:
        """The motion of the session of an endpoint; see `Endpoint.show_motion`. Raises NoSuchEndpoint."""
        return self._named(name).show_motion(known)

    def take_signals(self, name: str, no: int) -> tuple[Trace | None, int]:
        """Remove the signals of a case; see `SignalStore.take`. Raises NoSuchEndpoint, InvalidRequest."""
        endpoint = self._named(name)
        if endpoint.signals is None:
            raise InvalidRequest(f"name: the endpoint {name} records no signals")
        return endpoint.signals.take(no)

    def _named(self, name: str) -> Endpoint:
        with self._lock:
            endpoint = self._open.get(name)
        if endpoint is None:
            raise NoSuchEndpoint(f"name: there is no endpoint {name!r}")
        return endpoint

    def close_one(self, name: str) -> bool:
        """Close an endpoint; return whether all its calls have ended. Raises NoSuchEndpoint."""
        with self._lock:
            endpoint = self._open.pop(name, None)
        if endpoint is None:
            raise NoSuchEndpoint(f"name: there is no endpoint {name!r}")
        return endpoint.close()

    def close(self) -> None:
        """Close all."""
        with self._lock:
            names = list(self._open)
        for name in names:
            self.close_one(name)


class Administration(pb_grpc.SimulatorAdministrationServicer):
    """Opens and closes endpoints, as specified in administration.proto."""

    def __init__(self, endpoints: Endpoints) -> None:
        self._endpoints = endpoints

    @answering
    def OpenEndpoint(self, request: pb.OpenEndpointRequest, context: grpc.ServicerContext) -> pb.OpenEndpointResponse:
        """Open an endpoint."""
        order = SignalOrder(tuple(request.signals.names), request.signals.settling)
        wanted = order if request.HasField("signals") else None
        hardware = _orders().ordered(request.hardware) if request.HasField("hardware") else None
        target = self._endpoints.open(request.name, request.world_digest, wanted, hardware)
        return pb.OpenEndpointResponse(target=target)

    @answering
    def CheckHardware(
        self, request: pb.CheckHardwareRequest, context: grpc.ServicerContext
    ) -> pb.CheckHardwareResponse:
        """Compare devices that are not simulated with the world."""
        world = self._endpoints.check(source_of(request.world))
        orders = _orders()
        guard = orders.guard_of(request.hardware)
        try:
            texts = orders.check(world, orders.backends_of(request.hardware, world), guard, request.parameters)
        finally:
            if guard is not None:
                guard.close()
        return pb.CheckHardwareResponse(descriptions=texts)

    @answering
    def TakeHardwareReport(
        self, request: pb.TakeHardwareReportRequest, context: grpc.ServicerContext
    ) -> pb.TakeHardwareReportResponse:
        """End a case and return what was measured."""
        hardware = self._endpoints.hardware(request.name)
        if hardware is None:
            raise InvalidRequest(f"name: the endpoint {request.name} has simulated devices only")
        return _orders().report_message(hardware.report(request.case_no))

    @answering
    def StopHardware(self, request: pb.StopHardwareRequest, context: grpc.ServicerContext) -> pb.StopHardwareResponse:
        """Stop the devices."""
        hardware = self._endpoints.hardware(request.name)
        if hardware is not None:
            hardware.stop("the test application ended")
        return pb.StopHardwareResponse()

    @answering
    def TakeSignals(self, request: pb.TakeSignalsRequest, context: grpc.ServicerContext) -> pb.TakeSignalsResponse:
        """Return the signals of a case."""
        trace, times = self._endpoints.take_signals(request.name, request.case_no)
        if trace is None:
            return pb.TakeSignalsResponse()
        return pb.TakeSignalsResponse(
            times_kept=times,
            first_ns=trace.first_ns,
            timestep_ns=trace.timestep_ns,
            signals=[
                pb.Signal(name=name, values=trace.values[:, column].tolist()) for column, name in enumerate(trace.names)
            ],
        )

    @answering
    def ShowMotion(self, request: pb.ShowMotionRequest, context: grpc.ServicerContext) -> pb.ShowMotionResponse:
        """Return the motion of a running case."""
        gltf, version = self._endpoints.show_motion(request.name, request.known_version)
        return pb.ShowMotionResponse(gltf=gltf, version=version)

    @answering
    def CloseEndpoint(
        self, request: pb.CloseEndpointRequest, context: grpc.ServicerContext
    ) -> pb.CloseEndpointResponse:
        """Close an endpoint."""
        return pb.CloseEndpointResponse(idle=self._endpoints.close_one(request.name))


def _orders() -> ModuleType:
    """The module that needs `sitaf_hardware`, which only builds with other than simulated devices need."""
    try:
        return importlib.import_module("sitaf_bridge.hardware.orders")
    except ImportError as error:
        raise Unavailable(
            f"hardware: the package sitaf_hardware is missing where the simulator is installed ({error}); "
            "pip install ./hardware/python"
        ) from error
