"""Serves devices over gRPC."""

import contextlib
import os
import signal
import threading
from collections.abc import Iterator, Mapping
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import grpc

from sitaf_hardware.device import Device
from sitaf_hardware.provider import Provider
from sitaf_hardware.wire import hardware_pb2_grpc as pb_grpc

THREADS = 16
OPTIONS = (("grpc.so_reuseport", 0),)


@contextlib.contextmanager
def serving(devices: Mapping[str, Device] | Provider, address: str, name: str = "") -> Iterator[Provider]:
    """Serve devices at `unix:/PATH` or `127.0.0.1:PORT` until the end of the block; then they are stopped.

    Raises OSError if the address cannot be used.
    """
    provider = devices if isinstance(devices, Provider) else Provider(devices, name)
    pool = ThreadPoolExecutor(THREADS, thread_name_prefix="provider")
    server = grpc.server(pool, options=OPTIONS)
    pb_grpc.add_HardwareProviderServicer_to_server(provider, server)
    path = Path(address.removeprefix("unix:")) if address.startswith("unix:") else None
    if path is not None:
        # A provider that was killed leaves its socket.
        path.unlink(missing_ok=True)
    # Devices are for the owner of the socket.
    before = os.umask(0o077)
    try:
        server.add_insecure_port(address)
    except RuntimeError as error:
        raise OSError(f"cannot listen on {address}: {error}") from error
    finally:
        os.umask(before)
    server.start()
    try:
        yield provider
    finally:
        provider.close("the provider ends")
        server.stop(0.5).wait()
        pool.shutdown(wait=False, cancel_futures=True)


def serve(devices: Mapping[str, Device], address: str, name: str = "") -> None:
    """Serve devices until SIGTERM or SIGINT."""
    with contextlib.suppress(OSError):
        # A heartbeat must not wait for the processes of a build.
        os.setpriority(os.PRIO_PROCESS, 0, -10)
    ended = threading.Event()
    for number in (signal.SIGTERM, signal.SIGINT):
        signal.signal(number, lambda *_: ended.set())
    with serving(devices, address, name):
        print(f"listening {address}", flush=True)
        ended.wait()
