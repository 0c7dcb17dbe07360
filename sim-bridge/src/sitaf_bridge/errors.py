"""Errors by category; the server maps each category to a gRPC status code."""

from collections.abc import Iterable
from dataclasses import dataclass


class BridgeError(Exception):
    """A rejected request. The message says what is wrong, where, and what to do."""


class InvalidRequest(BridgeError):
    """The request violates the protocol or names something that the world does not declare."""


class UnreachableValue(BridgeError):
    """A parameter value that is outside of its range or that its binding cannot reach."""


class NoSuchSession(BridgeError):
    """The session does not exist: it was deleted, or its lease expired."""


class NoSuchEndpoint(BridgeError):
    """No endpoint of that name is open."""


class Forbidden(BridgeError):
    """The endpoint does not allow the request."""


class Diverged(BridgeError):
    """The simulation produced NaN, infinity or a huge value; the session is frozen."""


class LimitReached(BridgeError):
    """A limit of the bridge was exceeded; the message names the limit."""


class WrongState(BridgeError):
    """The session is not in the state that the request needs."""


class Unavailable(WrongState):
    """This machine lacks something that the request needs."""


class TimeReset(BridgeError):
    """Simulation time was reset while a caller waited for it."""


class Unauthenticated(BridgeError):
    """The request has no valid token."""


class Cancelled(BridgeError):
    """The caller disconnected during the request; nothing was changed."""


@dataclass(frozen=True, order=True)
class Problem:
    """One error in a world: file, line (None if unknown) and message."""

    file: str
    line: int | None
    message: str

    def __str__(self) -> str:
        """`file:line: message`, the format of compilers."""
        place = self.file if self.line is None else f"{self.file}:{self.line}"
        return f"{place}: {self.message}"


class BadWorld(InvalidRequest):
    """A world that cannot be simulated, with all errors that were found."""

    def __init__(self, problems: Iterable[Problem]) -> None:
        self.problems = tuple(problems)
        super().__init__("\n".join(str(problem) for problem in self.problems))
