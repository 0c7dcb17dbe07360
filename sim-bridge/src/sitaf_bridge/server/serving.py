"""The running server."""

import contextlib
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

import grpc

from sitaf_bridge.server.address import Address, BadAddress, Guard, TokenCheck
from sitaf_bridge.server.control import SimulationControl
from sitaf_bridge.server.endpoints import SERVER_OPTIONS, Administration, Endpoints
from sitaf_bridge.server.hardware import VirtualHardware
from sitaf_bridge.server.operation_socket import OperationSocket, path_of_operations
from sitaf_bridge.session.registry import Registry
from sitaf_bridge.wire import administration_pb2_grpc, simulation_pb2_grpc
from sitaf_bridge.world.catalog import Catalog

# Seconds for running calls to end when the server stops.
GRACE_S = 2.0


@dataclass(frozen=True)
class Settings:
    """Settings of the server. `default_lease_s`: for sessions without a lease; `endpoints`: folder of sockets."""

    address: Address
    default_lease_s: float
    max_sessions: int
    threads: int
    guard: Guard | None = None
    endpoints: Path | None = None


@contextlib.contextmanager
def serving(settings: Settings, catalog: Catalog) -> Iterator[str]:
    """Serve until the end of the block; yields the target for clients. Raises BadAddress."""
    registry = Registry(default_lease_s=settings.default_lease_s, max_sessions=settings.max_sessions)
    pool = ThreadPoolExecutor(settings.threads, thread_name_prefix="call")
    guard = settings.guard
    checks: list[grpc.ServerInterceptor] = [] if guard is None else [TokenCheck(guard.token)]
    server = grpc.server(pool, options=SERVER_OPTIONS, interceptors=checks)
    # Its connections could not be asked for the token.
    operations = (
        path_of_operations(settings.address.path) if settings.address.path is not None and guard is None else None
    )
    control = SimulationControl(catalog, registry, operation_socket=operations is not None)
    simulation_pb2_grpc.add_SimulationControlServicer_to_server(control, server)
    simulation_pb2_grpc.add_VirtualHardwareServicer_to_server(
        VirtualHardware(registry, max(1, settings.threads // 2)), server
    )
    endpoints, opened = None, None
    if settings.endpoints is not None:
        endpoints = Endpoints(settings.endpoints, catalog, settings.default_lease_s, settings.threads)
        administration_pb2_grpc.add_SimulatorAdministrationServicer_to_server(Administration(endpoints), server)
    try:
        try:
            target = settings.address.target
            port = (
                server.add_insecure_port(target)
                if guard is None
                else server.add_secure_port(target, guard.credentials())
            )
        except RuntimeError as error:
            raise BadAddress(f"cannot listen on {settings.address.target}: {error}") from error
        if operations is not None:
            try:
                opened = OperationSocket(operations, control.operated, settings.max_sessions)
            except OSError as error:
                raise BadAddress(f"cannot listen on {operations}: {error}") from error
        server.start()
        yield settings.address.bound(port)
    finally:
        stopped = server.stop(GRACE_S)
        if opened is not None:
            opened.close(GRACE_S)
        stopped.wait()
        pool.shutdown(wait=False, cancel_futures=True)
        registry.close()
        if endpoints is not None:
            endpoints.close()
