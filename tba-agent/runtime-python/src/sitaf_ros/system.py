"""One case: its nodes, its time, and the side of the test application."""

from __future__ import annotations

import sys
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass
from random import Random
from typing import TYPE_CHECKING, Any

from sitaf_ros.errors import NodeError
from sitaf_ros.graph import Delivery, Graph, Publication, Quality, Server, Subscribed
from sitaf_ros.messages import Message
from sitaf_ros.names import Remapping
from sitaf_ros.node_threads import CaseEnded, NodeThreads
from sitaf_ros.settings import Overrides, RosSettings
from sitaf_ros.terminal import NodeInput
from sitaf_ros.test_side import Ask, TestSide, full
from sitaf_ros.unobserved import RosReport

if TYPE_CHECKING:
    from sitaf_ros.application import RosApplication

CALLBACKS_AT_ONE_INSTANT = 20_000
PATIENCE_AT_THE_END_S = 5.0
# What every subscription accepts.
OFFERED = Quality(depth=1, transient_local=True, deadline_ns=0, manual_liveliness=True, lease_ns=0)


@dataclass(frozen=True)
class NodeView:
    """A node that was made."""

    name: str
    namespace: str
    full_name: str
    is_lifecycle: bool


@dataclass(frozen=True)
class TopicView:
    """A topic, and how many publishers and subscriptions the nodes have there."""

    type: str
    publishers: int
    subscriptions: int


class _TestEndpoint:
    """A publisher or subscription of the test application."""

    def __init__(self, receive: Callable[[Delivery], None] | None = None) -> None:
        self._receive = receive

    def matched(self, change: int) -> None:
        """The test does not ask for matches."""

    def incompatible_with(self, policy: str) -> None:
        """The graph's report names it."""

    def alive(self, change: int) -> None:
        """The test does not look at liveliness."""

    def receive(self, delivery: Delivery) -> None:
        """Keep a message for the driver."""
        if self._receive is not None:
            self._receive(delivery)


class RosSystem(TestSide):
    """Nodes of a case and everything around them; all methods are for the driver's thread unless they say so."""

    def __init__(self, application: RosApplication, settings: RosSettings) -> None:
        super().__init__(application, settings)
        self.threads = NodeThreads()
        self.graph = Graph(lambda: self.threads.now_ns)
        self.remapping = Remapping(dict(settings.remap))
        self.overrides = Overrides(settings)
        self.stdin = NodeInput(settings.stdin)
        self.random = Random(settings.callback_order)  # noqa: S311 -- an order, not a secret
        self.node_list: list[Any] = []
        self.main_thread: Any = None
        self.main_returned = False
        self._failure: NodeError | None = None
        self._reported = False
        self._for_test: deque[Callable[[], None]] = deque()
        self._advertised: dict[str, Publication] = {}
        self._callbacks, self._callbacks_at = 0, 0

    # Time.

    @property
    def now_ns(self) -> int:
        """Simulation time since the nodes were made."""
        return self.threads.now_ns

    def next_event_ns(self) -> int | None:
        """Return when a timer, sleep or timeout of the nodes, or a delayed answer, is next; None for never."""
        times = (self.next_planned_ns(), self.threads.next_deadline_ns())
        return min((time for time in times if time is not None), default=None)

    def run_until(self, time_ns: int) -> None:
        """Run everything that is due up to and including a time, each at its own time."""
        self._run(time_ns)
        self.threads.advance_to(time_ns)

    def run_before(self, time_ns: int) -> None:
        """Run everything that is due before a time, and set the time."""
        self._run(time_ns - 1)
        self.threads.now_ns = max(self.now_ns, time_ns)

    def _run(self, time_ns: int) -> None:
        if time_ns >= self.now_ns:
            self._make_due(self.now_ns)
        while True:
            self._settle()
            due = self.next_event_ns()
            if due is None or due > time_ns:
                return
            self._make_due(max(due, self.now_ns))

    def _make_due(self, time_ns: int) -> None:
        self.threads.now_ns = max(self.now_ns, time_ns)
        self.do_planned()
        self.threads.advance_to(self.now_ns)

    def _settle(self) -> None:
        while True:
            self.threads.run_ready()
            self._raise_failure()
            if not self._for_test:
                return
            while self._for_test:
                self._for_test.popleft()()

    # Failures; also called by node threads.

    def failed(self, where: str, cause: BaseException) -> None:
        """Keep the first failure of a node."""
        if self._failure is None and not isinstance(cause, SystemExit | KeyboardInterrupt | CaseEnded):
            self._failure = NodeError(where, cause)

    def _raise_failure(self) -> None:
        if self._failure is not None and not self._reported:
            self._reported = True
            raise self._failure from self._failure.cause

    def count_callback(self) -> None:
        """Called by node threads before a callback: endless callbacks at one instant take simulated time."""
        if self._callbacks_at != self.now_ns:
            self._callbacks_at, self._callbacks = self.now_ns, 0
        self._callbacks += 1
        if self._callbacks > CALLBACKS_AT_ONE_INSTANT and not self.threads.ending:
            self._callbacks = 0
            self.unobserved.warn(f"more than {CALLBACKS_AT_ONE_INSTANT} callbacks at one instant")
            self.threads.wait(self.now_ns + 1_000_000)

    # Topics.

    def advertise(self, topic: str, type_name: str, quality: Quality | None = None) -> Publication:
        """Make the test application a publisher; by default one that fits every subscription."""
        topic = full(topic)
        publication = self._advertised.get(topic)
        if publication is None:
            self.application.classes.message(type_name)
            publication = Publication(topic, type_name, quality or OFFERED, _TestEndpoint(), None)
            self._advertised[topic] = publication
            self.graph.add_publication(publication)
        return publication

    def send(self, topic: str, type_name: str, message: Message) -> None:
        """Publish a message at the current time."""
        self.graph.publish(self.advertise(topic, type_name), message)

    def ros_time_ns(self) -> int:
        """Return what ROS clocks of the nodes show."""
        from sitaf_ros.simulated_time import EPOCH_NS

        return self.now_ns + (0 if self.settings.use_sim_time else EPOCH_NS)

    def subscribe(self, topic: str, type_name: str, callback: Callable[[Any, int], None]) -> None:
        """Call back in the driver's thread with each message and its time of publication in ns."""
        self.application.classes.message(type_name)

        def receive(delivery: Delivery) -> None:
            self._for_test.append(lambda: callback(delivery.message, delivery.time_ns))

        quality = Quality(keep_all=True, reliable=False)
        self.graph.add_subscription(Subscribed(full(topic), type_name, quality, _TestEndpoint(receive), None))

    # Services and actions.

    def next_number(self) -> int:
        """Return the next number of an event or a goal."""
        return self.graph.next_number()

    def call(self, name: str, type_name: str, request: Message, respond: Callable[[Message], None]) -> bool:
        """Call a service; `respond` is called in the driver's thread. Return whether a node offers it."""

        def take(response: Message) -> None:
            self._for_test.append(lambda: respond(response))

        return self.graph.call(name, type_name, request, take)

    def serve(self, name: str, type_name: str, ask: Ask) -> None:
        """Offer a service to the nodes; `ask` is called in the driver's thread."""

        def take(number: int, request: Message, respond: Callable[[Message], None]) -> None:
            self._for_test.append(lambda: ask(number, request, respond))

        self.graph.add_server(Server(name, type_name, take, None))

    def service_ready(self, name: str) -> bool:
        """Tell whether a node offers a service."""
        return any(server.node is not None for server in self.graph.servers.get(full(name), ()))

    def action_ready(self, name: str) -> bool:
        """Tell whether a node offers an action."""
        return self.service_ready(f"{full(name)}/_action/send_goal")

    # What is there.

    def nodes(self) -> list[NodeView]:
        """Return the nodes that exist, in the order of creation."""
        return [
            NodeView(n.get_name(), n.get_namespace(), n.get_fully_qualified_name(), n._ros_is_lifecycle)
            for n in self.node_list
        ]

    def topics(self) -> dict[str, TopicView]:
        """Return the topics that the nodes use, sorted."""
        found: dict[str, TopicView] = {}
        for topic in sorted({*self.graph.publications, *self.graph.subscriptions}):
            publications = [p for p in self.graph.publications.get(topic, ()) if p.node is not None]
            subscriptions = [s for s in self.graph.subscriptions.get(topic, ()) if s.node is not None]
            for entry in [*publications, *subscriptions][:1]:
                found[topic] = TopicView(entry.type_name, len(publications), len(subscriptions))
        return found

    # Beginning and end.

    def begin(self, run: Callable[[], object]) -> None:
        """Make the main thread of the nodes ready."""

        def main() -> None:
            try:
                run()
            except (SystemExit, KeyboardInterrupt):
                pass  # as at the end of a process
            except Exception as e:
                self.failed("main", e)
            finally:
                self.main_returned = True

        from sitaf_ros.locks import Thread

        self.main_thread = Thread(name="MainThread")
        self.main_thread._sitaf_begin(self.threads, main)

    @property
    def ended(self) -> bool:
        """True when the main function has returned and no other thread runs."""
        return self.main_returned and not self.threads.live()

    def end(self) -> None:
        """End the case: spin returns, what follows runs, but publishes nothing."""
        self.graph.closed = True
        if not self.threads.end(PATIENCE_AT_THE_END_S):
            self.unobserved.warn("a thread of the node did not stop at the end of the case")
        sys.stdout.flush()

    def report(self) -> RosReport:
        """Return what the nodes did that nothing looked at."""
        if self.stdin.lacks_lines:
            self.unobserved.warn("the node waits for a line of standard input; stdin in activity.yaml can give it one")
        return self.unobserved.report(self.graph, self.threads.slowest_polls)
