"""Topics and services of a case: who publishes, who subscribes, who answers, and which qualities of service match."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Protocol

from sitaf_ros.messages import Message

INFINITE_NS = 2**63 - 1


@dataclass(frozen=True)
class Quality:
    """What a publisher offers or a subscription requests; the names are those of ROS's policies."""

    depth: int = 10
    keep_all: bool = False
    reliable: bool = True
    transient_local: bool = False
    deadline_ns: int = INFINITE_NS
    manual_liveliness: bool = False
    lease_ns: int = INFINITE_NS
    lifespan_ns: int = INFINITE_NS


def incompatible(offered: Quality, requested: Quality) -> str | None:
    """Return the policy that keeps the two from matching, as ROS's table of QoS compatibilities says."""
    if requested.reliable and not offered.reliable:
        return "RELIABILITY"
    if requested.transient_local and not offered.transient_local:
        return "DURABILITY"
    if offered.deadline_ns > requested.deadline_ns:
        return "DEADLINE"
    if requested.manual_liveliness and not offered.manual_liveliness:
        return "LIVELINESS"
    if offered.lease_ns > requested.lease_ns:
        return "LIVELINESS"
    return None


class Endpoint(Protocol):
    """What the graph tells a publisher or subscription."""

    def matched(self, change: int) -> None:
        """A counterpart appeared (+1) or left (-1)."""
        ...

    def incompatible_with(self, policy: str) -> None:
        """A counterpart asks for or offers another quality of service."""
        ...


class Receiver(Endpoint, Protocol):
    """What the graph tells a subscription."""

    def receive(self, delivery: Delivery) -> None:
        """Take a message."""
        ...

    def alive(self, change: int) -> None:
        """A publisher lost (-1) or regained (+1) its liveliness."""
        ...


@dataclass(frozen=True, slots=True)
class Delivery:
    """A message on its way: its place in the order of publications, and when it was published."""

    number: int
    message: Message
    time_ns: int
    publisher: Publication


@dataclass(eq=False)
class Publication:
    """A publisher in the graph."""

    topic: str
    type_name: str
    quality: Quality
    owner: Endpoint
    node: str | None
    """The full name of the node; None for the test application."""
    kept: deque[Delivery] = field(default_factory=deque)
    sent: int = 0


@dataclass(eq=False)
class Subscribed:
    """A subscription in the graph."""

    topic: str
    type_name: str
    quality: Quality
    owner: Receiver
    node: str | None
    received: int = 0


@dataclass(eq=False)
class Server:
    """A service in the graph; `ask` takes a request and a function for the response."""

    name: str
    type_name: str
    ask: Callable[[int, Message, Callable[[Message], None]], None]
    node: str | None
    asked: int = 0


@dataclass(eq=False)
class Calling:
    """A client in the graph."""

    name: str
    type_name: str
    node: str | None
    calls: int = 0


class Graph:
    """Everything by name."""

    def __init__(self, now_ns: Callable[[], int]) -> None:
        self._now_ns = now_ns
        self._numbers = 0
        self.closed = False
        self.publications: dict[str, list[Publication]] = {}
        self.subscriptions: dict[str, list[Subscribed]] = {}
        self.servers: dict[str, list[Server]] = {}
        self.clients: dict[str, list[Calling]] = {}
        self.incompatible: list[str] = []
        self.different_types: list[str] = []
        self.past_publications: list[Publication] = []
        self.past_subscriptions: list[Subscribed] = []
        self.watchers: list[Callable[[], None]] = []
        """Called once at the next change."""

    def changed(self) -> None:
        """Tell the watchers that something appeared or left."""
        watchers, self.watchers = self.watchers, []
        for watcher in watchers:
            watcher()

    def next_number(self) -> int:
        """Return the place of a new event in the order of all."""
        self._numbers += 1
        return self._numbers

    def type_of(self, topic: str) -> str | None:
        """Return the type of a topic that somebody uses."""
        for table in (self.publications, self.subscriptions):
            for entry in table.get(topic, ()):
                return entry.type_name
        return None

    def add_publication(self, publication: Publication) -> None:
        """Add a publisher and match it."""
        self.publications.setdefault(publication.topic, []).append(publication)
        self.past_publications.append(publication)
        for subscribed in list(self.subscriptions.get(publication.topic, ())):
            self._match(publication, subscribed)
        self.changed()

    def add_subscription(self, subscribed: Subscribed) -> None:
        """Add a subscription, match it, and deliver what transient-local publishers have kept."""
        self.subscriptions.setdefault(subscribed.topic, []).append(subscribed)
        self.past_subscriptions.append(subscribed)
        for publication in list(self.publications.get(subscribed.topic, ())):
            if self._match(publication, subscribed) and subscribed.quality.transient_local:
                for delivery in publication.kept:
                    if self._now_ns() - delivery.time_ns <= publication.quality.lifespan_ns:
                        self._deliver(delivery, subscribed)
        self.changed()

    def _match(self, publication: Publication, subscribed: Subscribed) -> bool:
        if publication.type_name != subscribed.type_name:
            types = f"{publication.type_name} and {subscribed.type_name}"
            self._note(publication, subscribed, types, self.different_types)
            return False
        policy = incompatible(publication.quality, subscribed.quality)
        if policy is not None:
            self._note(publication, subscribed, policy, self.incompatible)
            publication.owner.incompatible_with(policy)
            subscribed.owner.incompatible_with(policy)
            return False
        publication.owner.matched(1)
        subscribed.owner.matched(1)
        return True

    @staticmethod
    def _note(publication: Publication, subscribed: Subscribed, what: str, notes: list[str]) -> None:
        text = f"{publication.topic}: {publication.node or 'the test'} -> {subscribed.node or 'the test'}: {what}"
        if text not in notes:
            notes.append(text)

    def matches(self, publication: Publication, subscribed: Subscribed) -> bool:
        """Tell whether messages go from one to the other."""
        same = publication.type_name == subscribed.type_name
        return same and incompatible(publication.quality, subscribed.quality) is None

    def alive(self, publication: Publication, is_alive: bool) -> None:
        """Tell matching subscriptions that a publisher lost or regained its liveliness."""
        for subscribed in list(self.subscriptions.get(publication.topic, ())):
            if self.matches(publication, subscribed):
                subscribed.owner.alive(1 if is_alive else -1)

    def remove_publication(self, publication: Publication) -> None:
        """Take a publisher away."""
        if publication in self.publications.get(publication.topic, ()):
            self.publications[publication.topic].remove(publication)
            for subscribed in self.subscriptions.get(publication.topic, ()):
                if self.matches(publication, subscribed):
                    subscribed.owner.matched(-1)
            self.changed()

    def remove_subscription(self, subscribed: Subscribed) -> None:
        """Take a subscription away."""
        if subscribed in self.subscriptions.get(subscribed.topic, ()):
            self.subscriptions[subscribed.topic].remove(subscribed)
            for publication in self.publications.get(subscribed.topic, ()):
                if self.matches(publication, subscribed):
                    publication.owner.matched(-1)
            self.changed()

    def publish(self, publication: Publication, message: Message) -> None:
        """Deliver a copy of a message to each matching subscription."""
        if self.closed:
            return
        delivery = Delivery(self.next_number(), message.copy_message(), self._now_ns(), publication)
        publication.sent += 1
        if publication.quality.transient_local:
            publication.kept.append(delivery)
            while not publication.quality.keep_all and len(publication.kept) > max(1, publication.quality.depth):
                publication.kept.popleft()
        for subscribed in list(self.subscriptions.get(publication.topic, ())):
            if self.matches(publication, subscribed):
                self._deliver(delivery, subscribed)

    @staticmethod
    def _deliver(delivery: Delivery, subscribed: Subscribed) -> None:
        subscribed.received += 1
        copy = delivery.message.copy_message()
        subscribed.owner.receive(Delivery(delivery.number, copy, delivery.time_ns, delivery.publisher))

    def add_server(self, server: Server) -> None:
        """Add a service."""
        self.servers.setdefault(server.name, []).append(server)
        self.changed()

    def remove_server(self, server: Server) -> None:
        """Take a service away."""
        if server in self.servers.get(server.name, ()):
            self.servers[server.name].remove(server)
            self.changed()

    def server(self, name: str, type_name: str) -> Server | None:
        """Return the service of a name and type."""
        return next((s for s in self.servers.get(name, ()) if s.type_name == type_name), None)

    def call(self, name: str, type_name: str, request: Message, respond: Callable[[Message], None]) -> bool:
        """Send a request; return False if nobody offers the service, when no response ever comes."""
        server = self.server(name, type_name)
        if server is None or self.closed:
            return False
        server.asked += 1
        server.ask(self.next_number(), request.copy_message(), lambda response: respond(response.copy_message()))
        return True
