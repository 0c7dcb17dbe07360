"""The running server."""

import contextlib
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

import grpc

from sitaf_bridge.server.address import Address, BadAddress, Guard, TokenCheck
from sitaf_bridge.server.control import SimulationControl
from sitaf_bridge.server.hardware import VirtualHardware
from sitaf_bridge.session.registry import Registry
from sitaf_bridge.wire import simulation_pb2_grpc as pb_grpc
from sitaf_bridge.world.catalog import Catalog

MAX_MESSAGE_BYTES = 64 * 1024 * 1024
# Seconds that calls at work get to end when the server stops.
GRACE_S = 2.0


@dataclass(frozen=True)
class Settings:
    """How to serve. `default_lease_s` is of sessions that ask for none."""

    address: Address
    default_lease_s: float
    max_sessions: int
    threads: int
    guard: Guard | None = None


@contextlib.contextmanager
def serving(settings: Settings, catalog: Catalog) -> Iterator[str]:
    """Serve until the end of the block; gives the target that clients connect to. Raises BadAddress."""
    registry = Registry(default_lease_s=settings.default_lease_s, max_sessions=settings.max_sessions)
    pool = ThreadPoolExecutor(settings.threads, thread_name_prefix="call")
    options = [
        ("grpc.max_receive_message_length", MAX_MESSAGE_BYTES),
        # Two bridges on one port would share its calls at random.
        ("grpc.so_reuseport", 0),
    ]
    guard = settings.guard
    checks: list[grpc.ServerInterceptor] = [] if guard is None else [TokenCheck(guard.token)]
    server = grpc.server(pool, options=options, interceptors=checks)
    pb_grpc.add_SimulationControlServicer_to_server(SimulationControl(catalog, registry), server)
    pb_grpc.add_VirtualHardwareServicer_to_server(VirtualHardware(registry, max(1, settings.threads // 2)), server)
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
        server.start()
        yield settings.address.bound(port)
    finally:
        server.stop(GRACE_S).wait()
        pool.shutdown(wait=False, cancel_futures=True)
        registry.close()
