"""The values of output data ports of the component during a case, which trajectory conditions use."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

# Changes of all ports in a case that are recorded; a record has at most 1 MiB.
MOST_CHANGES = 20_000


@dataclass(slots=True)
class PortChanges:
    """The values of a port, or of a part of it: `(time_ns, literal)` whenever it was another one."""

    signal: str
    changes: list[tuple[int, str]] = field(default_factory=list)
    left_out: int = 0


class WatchedPorts:
    """Reads ports whenever simulation time is about to pass, which are all times at which they may have changed."""

    def __init__(self) -> None:
        self._ports: list[tuple[PortChanges, Callable[[], str]]] = []
        self._count = 0
        self._reading = False
        self._error: BaseException | None = None

    def watch(self, signal: str, read: Callable[[], str], now_ns: int) -> None:
        """Watch a port until the end of the case. Raises what `read` raises."""
        changes = PortChanges(signal)
        self._read(changes, read, now_ns)
        self._ports.append((changes, read))

    def take(self, now_ns: int) -> None:
        """Read all ports. What a port raises is raised by `require_read`, because the component may be running."""
        # A port may itself let time pass.
        if self._reading or self._error is not None:
            return
        self._reading = True
        try:
            for changes, read in self._ports:
                self._read(changes, read, now_ns)
        except BaseException as raised:
            self._error = raised
        finally:
            self._reading = False

    def require_read(self) -> None:
        """Raise what a port raised."""
        error, self._error = self._error, None
        if error is not None:
            raise error

    def end(self, call_ns: int) -> list[PortChanges]:
        """Stop watching, and return the values with times since the call."""
        ended = [
            PortChanges(port.signal, [(at - call_ns, literal) for at, literal in port.changes], port.left_out)
            for port, _ in self._ports
        ]
        self._ports.clear()
        self._count = 0
        self._error = None
        return ended

    def _read(self, port: PortChanges, read: Callable[[], str], now_ns: int) -> None:
        literal = read()
        changes = port.changes
        if changes and changes[-1][1] == literal:
            return
        if changes and changes[-1][0] == now_ns:
            changes[-1] = (now_ns, literal)
        elif self._count < MOST_CHANGES:
            self._count += 1
            changes.append((now_ns, literal))
        else:
            port.left_out += 1
