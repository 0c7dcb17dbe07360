"""The stream `Operate` without HTTP/2, for programs of the same machine.

gRPC passes each call between three threads, which takes longer than a step of most worlds. Here the thread of a
connection reads a frame, runs the operation and writes the answer.
"""

import os
import socket
import struct
import threading
import time
from collections.abc import Callable
from contextlib import suppress
from functools import partial
from pathlib import Path

from google.protobuf.message import DecodeError

from sitaf_bridge.server.address import UNIX_PATH_LIMIT
from sitaf_bridge.server.operations import IsActive
from sitaf_bridge.wire import simulation_pb2 as pb

SUFFIX = ".ops"
MAX_FRAME_BYTES = 64 * 1024 * 1024
LENGTH = struct.Struct("<I")
# A frame's bytes are stored as they arrive: a length alone costs nothing.
PIECE_BYTES = 64 * 1024
RETRY_S = 0.05

# Returns an encoded OperateResponse.
Operate = Callable[[pb.OperateRequest, IsActive], bytes]


def path_of_operations(grpc_socket: Path) -> Path | None:
    """The path of the socket of operations that belongs to a gRPC socket; None if it would be too long."""
    path = grpc_socket.with_name(grpc_socket.name + SUFFIX)
    return path if len(os.fsencode(path)) <= UNIX_PATH_LIMIT else None


class OperationSocket:
    """Accepts connections at a path until it is closed, each with a thread. Raises OSError.

    More than `limit` connections at a time are closed at once; their clients make unary calls.
    """

    def __init__(self, path: Path, operate: Operate, limit: int, mode: int | None = None) -> None:
        self._path = path
        self._operate = operate
        self._limit = limit
        self._lock = threading.Lock()
        self._connections: dict[socket.socket, threading.Thread] = {}
        self._closed = False
        self._listener = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
        try:
            if path.is_socket():
                # Of a process that was killed.
                path.unlink()
            self._listener.bind(str(path))
            if mode is not None:
                os.chmod(path, mode)
            self._listener.listen()
        except OSError:
            self._listener.close()
            raise
        self._acceptor = threading.Thread(target=self._accept, name="operations", daemon=True)
        self._acceptor.start()

    def close(self, timeout_s: float) -> bool:
        """Close all connections; return whether their operations have ended within the time."""
        ends = time.monotonic() + timeout_s
        with self._lock:
            self._closed = True
            threads = list(self._connections.values())
            for connection in self._connections:
                _shut_down(connection)
        _shut_down(self._listener)
        self._acceptor.join()
        self._listener.close()
        with suppress(FileNotFoundError):
            self._path.unlink()
        for thread in threads:
            thread.join(max(0.0, ends - time.monotonic()))
        return not any(thread.is_alive() for thread in threads)

    def _accept(self) -> None:
        while True:
            try:
                connection, _ = self._listener.accept()
            except OSError:
                if self._closed:
                    return
                # The client has gone, or too many files are open.
                time.sleep(RETRY_S)
                continue
            thread = threading.Thread(target=self._serve, args=(connection,), name="operation", daemon=True)
            with self._lock:
                if self._closed or len(self._connections) >= self._limit:
                    connection.close()
                    continue
                self._connections[connection] = thread
            thread.start()

    def _serve(self, connection: socket.socket) -> None:
        try:
            is_open = partial(_is_open, connection)
            # Until the client has gone, or has sent what is no frame.
            with suppress(OSError, EOFError, DecodeError):
                while True:
                    request = pb.OperateRequest.FromString(_read_frame(connection))
                    answer = self._operate(request, is_open)
                    connection.sendall(LENGTH.pack(len(answer)) + answer)
        finally:
            with self._lock:
                self._connections.pop(connection, None)
            connection.close()


def _read_frame(connection: socket.socket) -> bytes:
    (length,) = LENGTH.unpack(_read(connection, LENGTH.size))
    if length > MAX_FRAME_BYTES:
        raise EOFError
    return _read(connection, length)


def _read(connection: socket.socket, length: int) -> bytes:
    """Exactly so many bytes. Raises EOFError at the end of the connection."""
    piece = connection.recv(min(length, PIECE_BYTES)) if length else b""
    if len(piece) == length:
        return piece
    read = bytearray()
    while piece:
        read += piece
        if len(read) == length:
            return bytes(read)
        piece = connection.recv(min(length - len(read), PIECE_BYTES))
    raise EOFError


def _is_open(connection: socket.socket) -> bool:
    try:
        return connection.recv(1, socket.MSG_PEEK | socket.MSG_DONTWAIT) != b""
    except BlockingIOError:
        return True
    except OSError:
        return False


def _shut_down(connection: socket.socket) -> None:
    with suppress(OSError):
        connection.shutdown(socket.SHUT_RDWR)
