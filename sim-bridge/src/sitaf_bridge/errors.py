"""What can go wrong, by category; the server maps each category to one status code of the wire."""

from collections.abc import Iterable
from dataclasses import dataclass


class BridgeError(Exception):
    """A refused request. Its text says what, where, and what to do."""


class InvalidRequest(BridgeError):
    """The request contradicts the protocol or names something that the world does not declare."""


class UnreachableValue(BridgeError):
    """A parameter's value outside its declared range, or one that its binding cannot reach."""


class NoSuchSession(BridgeError):
    """No session of that id: it was deleted, or its lease ended."""


class NoSuchEndpoint(BridgeError):
    """No endpoint of that name is open."""


class Forbidden(BridgeError):
    """The endpoint does not offer what is asked for."""


class Diverged(BridgeError):
    """The simulation left the numbers; the session is frozen."""


class LimitReached(BridgeError):
    """A limit of the bridge was reached; the text names the limit."""


class NotNow(BridgeError):
    """The request does not fit the state of the session."""


class Unavailable(NotNow):
    """This machine lacks what the request needs."""


class TimeWentBack(BridgeError):
    """Simulation time was put back while a caller waited for it."""


class NotAllowed(BridgeError):
    """The caller has not shown the token."""


class Cancelled(BridgeError):
    """The caller went away while its request was carried out; nothing has changed."""


@dataclass(frozen=True, order=True)
class Problem:
    """One thing wrong with a world: in which file, on which line (None if unknown), and what."""

    file: str
    line: int | None
    message: str

    def __str__(self) -> str:
        """`file:line: message`, as compilers print it."""
        place = self.file if self.line is None else f"{self.file}:{self.line}"
        return f"{place}: {self.message}"


class BadWorld(InvalidRequest):
    """A world that cannot be simulated, with every problem that was found."""

    def __init__(self, problems: Iterable[Problem]) -> None:
        self.problems = tuple(problems)
        super().__init__("\n".join(str(problem) for problem in self.problems))
