"""Operations of a session over a socket of frames, which take a tenth of the time of gRPC calls."""

from __future__ import annotations

import socket
import struct
import threading
from typing import Any

import grpc

from sitaf_runtime.simulation.wire.sitaf.sim.v1 import simulation_pb2 as pb

_LENGTH = struct.Struct("<I")
_CODES = {code.value[0]: code for code in grpc.StatusCode}
# What precedes the length and the bytes of a field that is a message.
_TAGS = {field.name: bytes([field.number << 3 | 2]) for field in pb.OperateRequest.DESCRIPTOR.fields}
# For the answer to a ping, after which the socket is used.
_PING_TIMEOUT_S = 5.0


class Refused(grpc.RpcError):
    """An operation that failed, with the status of the unary call."""

    def __init__(self, code: grpc.StatusCode, details: str) -> None:
        super().__init__(details)
        self._code = code
        self._details = details

    def code(self) -> grpc.StatusCode:
        """The status code."""
        return self._code

    def details(self) -> str:
        """The message."""
        return self._details


class OperationSocket:
    """A connection to a socket of operations; one operation at a time. Raises OSError if it is not served."""

    def __init__(self, path: str) -> None:
        self._path = path
        self._lock = threading.Lock()
        self._socket = self._connected()
        try:
            self._exchange("ping", pb.PingRequest(), _PING_TIMEOUT_S)
        except BaseException:
            self.close()
            raise

    def operate(self, name: str, request: Any, timeout_s: float) -> Any:
        """Run an operation, named as in OperateRequest; the answer has its `state`. Raises Refused."""
        try:
            with self._lock:
                answer = self._exchange(name, request, timeout_s)
        except TimeoutError:
            raise Refused(grpc.StatusCode.DEADLINE_EXCEEDED, f"no answer within {timeout_s:g} s") from None
        except OSError as e:
            raise Refused(grpc.StatusCode.UNAVAILABLE, f"the connection ended: {e}") from None
        if answer.HasField("refusal"):
            code = _CODES.get(answer.refusal.code, grpc.StatusCode.UNKNOWN)
            raise Refused(code, answer.refusal.message)
        return answer

    def close(self) -> None:
        """Close the connection."""
        self._socket.close()

    def _connected(self) -> socket.socket:
        connection = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
        try:
            connection.settimeout(_PING_TIMEOUT_S)
            connection.connect(self._path)
        except BaseException:
            connection.close()
            raise
        return connection

    def _exchange(self, name: str, request: Any, timeout_s: float) -> pb.OperateResponse:
        if self._socket.fileno() < 0:
            self._socket = self._connected()
        try:
            self._socket.settimeout(timeout_s)
            message = request.SerializeToString()
            # An OperateRequest with this message would copy it.
            head = _TAGS[name] + _varint(len(message))
            self._socket.sendall(_LENGTH.pack(len(head) + len(message)) + head + message)
            (length,) = _LENGTH.unpack(self._read(_LENGTH.size))
            return pb.OperateResponse.FromString(self._read(length))
        except BaseException:
            # Its answer would be taken for that of the next operation. The simulator cancels the operation.
            self._socket.close()
            raise

    def _read(self, length: int) -> bytes:
        piece = self._socket.recv(length) if length else b""
        if len(piece) == length:
            return piece
        read = bytearray()
        while piece:
            read += piece
            if len(read) == length:
                return bytes(read)
            piece = self._socket.recv(length - len(read))
        raise ConnectionError("end of stream")


def _varint(number: int) -> bytes:
    parts = bytearray()
    while number > 0x7F:
        parts.append(number & 0x7F | 0x80)
        number >>= 7
    parts.append(number)
    return bytes(parts)
