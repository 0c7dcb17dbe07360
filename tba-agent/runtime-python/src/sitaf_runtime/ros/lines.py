"""Messages between the process of the test driver and that of the node: one JSON object a line."""

from __future__ import annotations

import json
import socket
from array import array
from collections.abc import Iterable
from typing import Any


def packed(numbers: Iterable[float]) -> str:
    """Numbers in a message: a scan has hundreds, of which the decimal digits take longer than all else."""
    return array("d", numbers).tobytes().hex()


def unpacked(text: str) -> list[float]:
    """The numbers of `packed`."""
    numbers = array("d")
    numbers.frombytes(bytes.fromhex(text))
    return numbers.tolist()


class Lines:
    """One end of a connection."""

    def __init__(self, end: socket.socket) -> None:
        self._socket = end
        self._stream = end.makefile("rb")

    def send(self, message: dict[str, Any]) -> None:
        """Send a message. Raises OSError when the other process has ended."""
        self._socket.sendall(json.dumps(message).encode() + b"\n")

    def receive(self) -> dict[str, Any]:
        """Wait for a message. Raises EOFError when the other process has ended."""
        line = self._stream.readline()
        if not line.endswith(b"\n"):
            raise EOFError("the process of the node has ended")
        return json.loads(line)

    def ask(self, message: dict[str, Any]) -> dict[str, Any]:
        """Send a message and wait for the answer."""
        self.send(message)
        return self.receive()
