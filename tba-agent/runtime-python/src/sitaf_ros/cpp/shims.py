"""What a case of the test application uses in place of Python's threads and graph."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from sitaf_ros.cpp.library import Event, Library
from sitaf_ros.graph import Publication, Server
from sitaf_ros.messages import Message, MessageClasses
from sitaf_ros.serialization import Reader, serialize


class CppThreads:
    """The threads of the node, which the library runs."""

    def __init__(self, library: Library, after: Callable[[], bool]) -> None:
        self._library = library
        self._after = after
        self._now_ns = 0
        self.ending = False
        self.slowest_polls = 0

    @property
    def now_ns(self) -> int:
        """Simulation time."""
        return self._now_ns

    @now_ns.setter
    def now_ns(self, time_ns: int) -> None:
        self._now_ns = max(self._now_ns, time_ns)
        self._library.set_now(self._now_ns)

    def run_ready(self, patience_s: float = -1) -> bool:
        """Run threads until all wait."""
        del patience_s
        self._library.run_ready()
        while self._after():
            self._library.run_ready()
        return True

    def next_deadline_ns(self) -> int | None:
        """Return when the first wait ends."""
        deadline = self._library.next_deadline()
        return None if deadline < 0 else deadline

    def advance_to(self, time_ns: int) -> None:
        """Set the time and make the threads ready whose waits end by then."""
        self._now_ns = max(self._now_ns, time_ns)
        self._library.advance(self._now_ns)

    def live(self) -> list[Any]:
        """The driver does not ask for these."""
        return []


@dataclass(frozen=True)
class _Subscription:
    type_name: str
    callback: Callable[[Any, int], None]


class CppGraph:
    """The test's part of the graph; the rest is in the library."""

    def __init__(self, library: Library, classes: MessageClasses) -> None:
        self._library = library
        self._classes = classes
        self._advertised: dict[int, int] = {}
        self._servers: dict[int, tuple[Server, Any]] = {}
        self._calls: dict[int, tuple[Any, Callable[[Message], None]]] = {}
        self.test_subscriptions: dict[int, _Subscription] = {}
        self.publications: dict[str, list[Any]] = {}
        self.subscriptions: dict[str, list[Any]] = {}

    def next_number(self) -> int:
        """Return the place of a new event in the order of all."""
        return self._library.number()

    def read(self, type_name: str, data: bytes) -> Message:
        """Read a message."""
        return self._read(self._classes.message(type_name), data)

    def _read(self, cls: Any, data: bytes) -> Message:
        return Reader(data, self._classes.message).message(cls)

    def add_publication(self, publication: Publication) -> None:
        """Add a publisher of the test."""
        self._advertised[id(publication)] = self._library.advertise(publication.topic, publication.type_name)

    def publish(self, publication: Publication, message: Message) -> None:
        """Publish for the test."""
        self._library.publish(self._advertised[id(publication)], serialize(message))

    def subscribe(self, topic: str, type_name: str, callback: Callable[[Any, int], None]) -> None:
        """Add a subscription of the test."""
        self.test_subscriptions[self._library.subscribe(topic, type_name)] = _Subscription(type_name, callback)

    def add_server(self, server: Server) -> None:
        """Add a service of the test."""
        request = self._classes.message(server.type_name).Request
        self._servers[self._library.serve(server.name, server.type_name)] = (server, request)

    def asked(self, event: Event) -> None:
        """Give a request to the service of the test."""
        server, request = self._servers[event.id]
        number = event.number
        server.ask(
            number,
            self._read(request, event.bytes),
            lambda response: self._library.respond(number, serialize(response)),
        )

    def call(self, name: str, type_name: str, request: Message, respond: Callable[[Message], None]) -> bool:
        """Call a service of the nodes."""
        number = self._library.call(name, type_name, serialize(request))
        if number:
            self._calls[number] = (self._classes.message(type_name).Response, respond)
        return bool(number)

    def answered(self, event: Event) -> None:
        """Give the response to the caller."""
        cls, respond = self._calls.pop(event.id)
        respond(self._read(cls, event.bytes))
