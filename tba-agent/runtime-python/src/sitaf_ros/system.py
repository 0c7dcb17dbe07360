"""One case: its nodes, its time, and the side of the test application."""

from __future__ import annotations

import sys
from collections import deque
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from random import Random
from typing import TYPE_CHECKING, Any

from sitaf_ros import conversion
from sitaf_ros.action_test import ActionAnswer, GoalUnderTest, serve_action
from sitaf_ros.errors import NodeError
from sitaf_ros.graph import Delivery, Graph, Publication, Quality, Server, Subscribed
from sitaf_ros.messages import Message
from sitaf_ros.names import Remapping
from sitaf_ros.node_threads import CaseEnded, NodeThreads
from sitaf_ros.settings import Overrides, RosSettings
from sitaf_ros.terminal import NodeInput
from sitaf_ros.unobserved import RosReport, Unobserved

if TYPE_CHECKING:
    from sitaf_ros.application import RosApplication

CALLBACKS_AT_ONE_INSTANT = 20_000
PATIENCE_AT_THE_END_S = 5.0
# What every subscription accepts.
OFFERED = Quality(depth=1, transient_local=True, deadline_ns=0, manual_liveliness=True, lease_ns=0)


@dataclass(frozen=True)
class Delayed:
    """A response of a service that comes after a time."""

    seconds: float
    response: Any


@dataclass
class ServiceCall:
    """A call by the test application."""

    done: bool = False
    response: Any = None
    error: str | None = None
    then: Callable[[Any], None] | None = None

    def finish(self, response: Any) -> None:
        """Take the response."""
        self.done, self.response = True, response
        if self.then is not None:
            self.then(response)


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


@dataclass(order=True)
class _Later:
    time_ns: int
    number: int
    act: Callable[[], None] = field(compare=False)


class RosSystem:
    """Nodes of a case and everything around them; all methods are for the driver's thread unless they say so."""

    def __init__(self, application: RosApplication, settings: RosSettings) -> None:
        self.application = application
        self.settings = settings
        self.threads = NodeThreads()
        self.graph = Graph(lambda: self.threads.now_ns)
        self.remapping = Remapping(dict(settings.remap))
        self.overrides = Overrides(settings)
        self.stdin = NodeInput(settings.stdin)
        self.random = Random(settings.callback_order)  # noqa: S311 -- an order, not a secret
        self.unobserved = Unobserved()
        self.node_list: list[Any] = []
        self.main_thread: Any = None
        self.main_returned = False
        self._failure: NodeError | None = None
        self._reported = False
        self._for_test: deque[Callable[[], None]] = deque()
        self._later: list[_Later] = []
        self._advertised: dict[str, Publication] = {}
        self._callbacks, self._callbacks_at = 0, 0

    # Time.

    @property
    def now_ns(self) -> int:
        """Simulation time since the nodes were made."""
        return self.threads.now_ns

    def next_event_ns(self) -> int | None:
        """Return when a timer, sleep or timeout of the nodes, or a delayed answer, is next; None for never."""
        times = [later.time_ns for later in self._later[:1]]
        deadline = self.threads.next_deadline_ns()
        return min([*times, *([] if deadline is None else [deadline])], default=None)

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
        while self._later and self._later[0].time_ns <= self.now_ns:
            self._later.pop(0).act()
        self.threads.advance_to(self.now_ns)

    def _settle(self) -> None:
        while True:
            self.threads.run_ready()
            self._raise_failure()
            if not self._for_test:
                return
            while self._for_test:
                self._for_test.popleft()()

    def later(self, seconds: float, act: Callable[[], None]) -> None:
        """Do something for the test side after a time."""
        self._later.append(_Later(self.now_ns + max(0, round(seconds * 1e9)), self.graph.next_number(), act))
        self._later.sort()

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

    # Messages.

    def new_message(self, type_name: str, fields: Mapping[str, Any] | Message) -> Any:
        """Make a message; what is not named has its default."""
        return conversion.from_fields(self.application.classes, type_name, fields)

    def default(self, type_name: str) -> Any:
        """Make a message of defaults."""
        return self.application.classes.message(type_name)()

    @staticmethod
    def fields(message: Message, raw: bool = False) -> dict[str, Any]:
        """Return a message as plain values; with `raw`, number arrays stay arrays."""
        return conversion.to_fields(message, raw)

    # Topics.

    def advertise(self, topic: str, type_name: str, quality: Quality | None = None) -> Publication:
        """Make the test application a publisher; by default one that fits every subscription."""
        topic = _full(topic)
        publication = self._advertised.get(topic)
        if publication is None:
            self.application.classes.message(type_name)
            publication = Publication(topic, type_name, quality or OFFERED, _TestEndpoint(), None)
            self._advertised[topic] = publication
            self.graph.add_publication(publication)
        return publication

    def publish(self, topic: str, type_name: str, fields: Mapping[str, Any] | Message, stamp: bool = True) -> None:
        """Publish at the current time; a `header.stamp` that is not named is the time of publication."""
        message = self.new_message(type_name, fields)
        if stamp and isinstance(fields, Mapping):
            header = message._fields_and_field_types.get("header")
            named = fields.get("header")
            if header == "std_msgs/Header" and not (isinstance(named, Mapping) and "stamp" in named):
                message.header.stamp.sec, message.header.stamp.nanosec = divmod(self.ros_time_ns(), 10**9)
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
        self.graph.add_subscription(Subscribed(_full(topic), type_name, quality, _TestEndpoint(receive), None))

    # Services and actions.

    def call_service(
        self, name: str, type_name: str, fields: Mapping[str, Any] | Message, then: Callable[[Any], None] | None = None
    ) -> ServiceCall:
        """Call a service of the nodes; run time until the call is done."""
        service = self.application.classes.message(type_name)
        call = ServiceCall(then=then)
        request = conversion.from_fields(self.application.classes, service.Request._definition.name, fields)

        def respond(response: Message) -> None:
            self._for_test.append(lambda: call.finish(response))

        if not self.graph.call(_full(name), type_name, request, respond):
            call.error = f"no node offers the service {_full(name)} of type {type_name}"
        return call

    def serve_service(self, name: str, type_name: str, answer: Callable[[Any], Any]) -> None:
        """Answer a service for the nodes; `answer` returns a response, or `Delayed`; an exception is no answer."""
        service = self.application.classes.message(type_name)
        response_name = service.Response._definition.name

        def ask(_: int, request: Message, respond: Callable[[Message], None]) -> None:
            self._for_test.append(lambda: reply(request, respond))

        def reply(request: Message, respond: Callable[[Message], None]) -> None:
            try:
                answered = answer(request)
            except Exception as e:
                self.unobserved.warn(f"{name}: the test application gives no answer: {e}")
                return
            delay = answered.seconds if isinstance(answered, Delayed) else 0.0
            fields = answered.response if isinstance(answered, Delayed) else answered
            response = conversion.from_fields(self.application.classes, response_name, fields or {})
            if delay > 0:
                self.later(delay, lambda: respond(response))
            else:
                respond(response)

        self.graph.add_server(Server(_full(name), type_name, ask, None))

    def send_goal(
        self,
        name: str,
        type_name: str,
        fields: Mapping[str, Any] | Message,
        feedback: Callable[[Any, int], None] | None = None,
    ) -> GoalUnderTest:
        """Send a goal to an action server of the nodes."""
        return GoalUnderTest(self, _full(name), type_name, fields, feedback)

    def serve_action(self, name: str, type_name: str, answer: Callable[[Any], ActionAnswer]) -> None:
        """Be an action server for the nodes."""
        serve_action(self, _full(name), type_name, answer)

    def service_ready(self, name: str) -> bool:
        """Tell whether a node offers a service."""
        return any(server.node is not None for server in self.graph.servers.get(_full(name), ()))

    def action_ready(self, name: str) -> bool:
        """Tell whether a node offers an action."""
        return self.service_ready(f"{_full(name)}/_action/send_goal")

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
        return self.unobserved.report(self.graph, self.threads.slowest_polls)


def _full(name: str) -> str:
    return name if name.startswith("/") else f"/{name}"
