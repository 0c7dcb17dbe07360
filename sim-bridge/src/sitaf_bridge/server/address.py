"""The address to listen on: this machine only, or others with TLS and a token."""

import hmac
import ipaddress
import re
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import grpc

UNIX_PATH_LIMIT = 107
MIN_TOKEN_LENGTH = 16


class BadAddress(ValueError):
    """An address that is malformed or not allowed."""


@dataclass(frozen=True)
class Address:
    """A gRPC target; port 0 selects any free port."""

    target: str
    is_unix: bool

    @property
    def path(self) -> Path | None:
        """The path of a Unix socket."""
        return Path(self.target.removeprefix("unix:")) if self.is_unix else None

    def bound(self, port: int) -> str:
        """The target for clients, once the port is known."""
        return self.target if self.is_unix else f"{self.target.rsplit(':', 1)[0]}:{port}"


@dataclass(frozen=True)
class Guard:
    """PEM certificate chain and key of the server, and the token that every call must contain."""

    certificate: bytes
    key: bytes
    token: str

    def credentials(self) -> grpc.ServerCredentials:
        """TLS credentials of the server's port."""
        return grpc.ssl_server_credentials([(self.key, self.certificate)])


def read_guard(certificate: Path | None, key: Path | None, token: Path | None) -> Guard | None:
    """Read the guard from three files; None if none is given. Raises BadAddress."""
    if certificate is None and key is None and token is None:
        return None
    if certificate is None or key is None or token is None:
        raise BadAddress("--tls-cert, --tls-key and --token-file must be given together")
    try:
        secret = token.read_text("utf-8").strip()
        guard = Guard(certificate.read_bytes(), key.read_bytes(), secret)
    except (OSError, UnicodeDecodeError) as error:
        raise BadAddress(f"cannot read the files of the certificate, key or token: {error}") from error
    if len(secret) < MIN_TOKEN_LENGTH or not secret.isascii() or not secret.isprintable():
        raise BadAddress(f"{token}: the token must have at least {MIN_TOKEN_LENGTH} printable ASCII characters")
    return guard


class TokenCheck(grpc.ServerInterceptor):
    """Rejects calls without the token before their content is read."""

    def __init__(self, token: str) -> None:
        self._expected = f"Bearer {token}".encode()

    def intercept_service(
        self,
        continuation: Callable[[grpc.HandlerCallDetails], grpc.RpcMethodHandler | None],
        handler_call_details: grpc.HandlerCallDetails,
    ) -> grpc.RpcMethodHandler | None:
        """Continue the call, or reject it with UNAUTHENTICATED."""
        shown = dict(handler_call_details.invocation_metadata or ()).get("authorization", "")
        given = shown if isinstance(shown, bytes) else shown.encode()
        if hmac.compare_digest(given, self._expected):
            return continuation(handler_call_details)
        handler = continuation(handler_call_details)
        refuse: Any = _refuse_stream if handler is not None and handler.request_streaming else _refuse
        return refuse


def _abort(_request: Any, context: grpc.ServicerContext) -> Any:
    context.abort(grpc.StatusCode.UNAUTHENTICATED, "the token is missing: metadata `authorization: Bearer TOKEN`")


_refuse = grpc.unary_unary_rpc_method_handler(_abort)
_refuse_stream = grpc.stream_stream_rpc_method_handler(_abort)


def parse_address(text: str, guard: Guard | None = None) -> Address:
    """Parse `HOST:PORT`, `[::1]:PORT` or `unix:PATH`; without a guard only loopback. Raises BadAddress."""
    if text.startswith("unix:"):
        path = text.removeprefix("unix:")
        if path.startswith("//"):
            path = path.removeprefix("//")
        if not path:
            raise BadAddress(f"{text}: the socket path is missing; write unix:/path/to/socket")
        full = str(Path(path).absolute())
        if len(full.encode()) > UNIX_PATH_LIMIT:
            raise BadAddress(f"{text}: a socket path has at most {UNIX_PATH_LIMIT} bytes")
        return Address(f"unix:{full}", is_unix=True)
    match = re.fullmatch(r"(?P<host>\[[0-9A-Fa-f:]+\]|[^:\[\]]+):(?P<port>\d{1,5})", text)
    if match is None or int(match["port"]) > 65535:
        raise BadAddress(f"{text}: write HOST:PORT, such as 127.0.0.1:0, or unix:/path/to/socket")
    host = "127.0.0.1" if match["host"] == "localhost" else match["host"]
    try:
        loopback = ipaddress.ip_address(host.strip("[]")).is_loopback
    except ValueError:
        loopback = False
    if not loopback and guard is None:
        raise BadAddress(
            f"{text}: addresses other than loopback (127.0.0.1, [::1]) and Unix sockets need TLS and a token: "
            "add --tls-cert, --tls-key and --token-file"
        )
    return Address(f"{host}:{match['port']}", is_unix=False)
