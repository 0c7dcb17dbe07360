"""Where the bridge may listen: on this machine only."""

import ipaddress
import re
from dataclasses import dataclass
from pathlib import Path

UNIX_PATH_LIMIT = 107


class BadAddress(ValueError):
    """An address that is malformed, or that other machines could reach."""


@dataclass(frozen=True)
class Address:
    """A gRPC target; port 0 stands for any free one."""

    target: str
    is_unix: bool

    def bound(self, port: int) -> str:
        """The target that a client uses, once the port is known."""
        return self.target if self.is_unix else f"{self.target.rsplit(':', 1)[0]}:{port}"


def parse_address(text: str) -> Address:
    """`HOST:PORT` with a loopback host, `[::1]:PORT`, or `unix:PATH`. Raises BadAddress."""
    if text.startswith("unix:"):
        path = text.removeprefix("unix:")
        if path.startswith("//"):
            path = path.removeprefix("//")
        if not path:
            raise BadAddress(f"{text}: the path of the socket is missing; write unix:/path/to/socket")
        full = str(Path(path).absolute())
        if len(full.encode()) > UNIX_PATH_LIMIT:
            raise BadAddress(f"{text}: the path of a socket has at most {UNIX_PATH_LIMIT} bytes")
        return Address(f"unix:{full}", is_unix=True)
    match = re.fullmatch(r"(?P<host>\[[0-9A-Fa-f:]+\]|[^:\[\]]+):(?P<port>\d{1,5})", text)
    if match is None or int(match["port"]) > 65535:
        raise BadAddress(f"{text}: write HOST:PORT, such as 127.0.0.1:0, or unix:/path/to/socket")
    host = "127.0.0.1" if match["host"] == "localhost" else match["host"]
    try:
        loopback = ipaddress.ip_address(host.strip("[]")).is_loopback
    except ValueError:
        loopback = False
    if not loopback:
        raise BadAddress(
            f"{text}: the bridge listens on loopback (127.0.0.1, [::1]) and Unix sockets only: "
            "a simulator that other machines reach would need TLS and a token, which it does not have yet"
        )
    return Address(f"{host}:{match['port']}", is_unix=False)
