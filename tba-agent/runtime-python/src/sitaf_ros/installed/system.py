"""One case with the installed ROS 2: the test application is a node of its own context next to the nodes under test."""

from __future__ import annotations

import importlib
import threading
import time
from collections import deque
from collections.abc import Callable
from contextlib import suppress
from typing import TYPE_CHECKING, Any

from sitaf_ros import serialization
from sitaf_ros.errors import NodeError, is_regular_end
from sitaf_ros.installed.observed import Observed
from sitaf_ros.installed.quiet import Quiet
from sitaf_ros.installed.types import installed
from sitaf_ros.messages import Message
from sitaf_ros.settings import RosSettings
from sitaf_ros.test_side import Ask, TestSide
from sitaf_ros.unobserved import RosReport

if TYPE_CHECKING:
    from sitaf_ros.installed.application import InstalledApplication

NODE = "sitaf_test_application"
_MS = 1_000_000
# The steps of /clock.
_STEP_NS = _MS
# For the nodes to be there: discovery within a process takes tenths of a second.
_READY_AT_MOST_S = 10.0
_UNCHANGED_S = 0.1
# Where the quality of service does not fit, or a node does not use ROS time, they never meet.
_UNCONNECTED_S = 2.0
# A callback may calculate for long; time waits for it.
_REST_AT_MOST_S = 20.0
_END_AT_MOST_S = 5.0
_MATCHED_AT_MOST_S = 1.0


class InstalledSystem(TestSide):
    """The nodes of a case run in the main thread of the process, this in another one."""

    def __init__(self, application: InstalledApplication, settings: RosSettings, run: Callable[[], object]) -> None:
        super().__init__(application, settings)
        self._run = run
        self._begin = application.begin
        self._application_ends = application.end_nodes
        self._now_ns = 0
        self._clock_ns = -1
        self._number = 0
        self._failure: NodeError | None = None
        self._has_returned = False
        self._begun = self._ended = self._restless = self._has_sent = False
        self._due_s = 0.0
        self._publishers: dict[str, Any] = {}
        self._clients: dict[str, Any] = {}
        executors: Any = importlib.import_module("rclpy.executors")
        nodes: Any = importlib.import_module("rclpy.node")
        self._qos: Any = importlib.import_module("rclpy.qos")
        self._task: Any = importlib.import_module("rclpy.task")
        self._serialization: Any = importlib.import_module("rclpy.serialization")
        self._context = importlib.import_module("rclpy.context").Context()
        self._context.init(args=[])
        self._node = nodes.Node(
            NODE,
            context=self._context,
            use_global_arguments=False,
            enable_rosout=False,
            start_parameter_services=False,
        )
        self._executor = executors.SingleThreadedExecutor(context=self._context)
        self._executor.add_node(self._node)
        # What comes waits for the driver's thread.
        self._came: deque[Callable[[], None]] = deque()
        self._receiver = threading.Thread(target=self._receive, name="sitaf-receiver", daemon=True)
        self._receiver.start()
        self._clock_class = installed("rosgraph_msgs/msg/Clock")
        self._clock = self._node.create_publisher(self._clock_class, "/clock", self._profile())
        self._observed = Observed(self, self._node)
        self._quiet = Quiet()
        if settings.callback_order:
            self.unobserved.warn("ros.callback_order has no effect: the installed ROS 2 orders callbacks itself")

    # Time.

    @property
    def now_ns(self) -> int:
        """Simulation time since the nodes were made."""
        return self._now_ns

    def ros_time_ns(self) -> int:
        """Return what ROS clocks of the nodes show: `/clock` begins at 0."""
        return self._now_ns

    def next_number(self) -> int:
        """Return the next number of an event or a goal."""
        self._number += 1
        return self._number

    def next_event_ns(self) -> int | None:
        """Return the next step of `/clock`: when a node does something is not known before."""
        return self._now_ns + _STEP_NS

    def run_until(self, time_ns: int) -> None:
        """Let time pass up to and including a time."""
        self._begin_nodes()
        if self._has_sent:
            # What was published at this time comes before what timers do now.
            self._has_sent = False
            self._rest()
        self._pass(time_ns)
        if self._clock_ns < time_ns:
            self._step(time_ns)

    def run_before(self, time_ns: int) -> None:
        """Let time pass up to a time; what the test does then comes before what timers do at that time."""
        self._begin_nodes()
        if time_ns > self._now_ns:
            self._pass(time_ns)
            self._now_ns = time_ns

    def _pass(self, time_ns: int) -> None:
        while (following := self._clock_ns - self._clock_ns % _STEP_NS + _STEP_NS) < time_ns:
            self._step(following)

    def _step(self, time_ns: int) -> None:
        """Set the time, when it has passed in real time, too, and let the nodes do what is due."""
        real_s = time.monotonic()
        self._due_s = max(self._due_s + (time_ns - self._clock_ns) / 1e9, real_s)
        time.sleep(self._due_s - real_s)
        self._now_ns = max(self._now_ns, time_ns)
        self._clock_ns = time_ns
        clock = self._clock_class()
        clock.clock.sec, clock.clock.nanosec = divmod(time_ns, 10**9)
        self._clock.publish(clock)
        self._rest()

    def _rest(self) -> None:
        """Wait until the nodes rest and there is nothing to answer."""
        while True:
            if not self._restless and not self._quiet.wait(_REST_AT_MOST_S):
                self._restless = True
                text = f"a thread of the node did not rest for {_REST_AT_MOST_S:.0f} s; time no longer waits for it"
                self.unobserved.warn(text)
            has_come = bool(self._came)
            self._take()
            if not has_come and not self.do_planned():
                return

    def _take(self) -> None:
        """Take all messages and calls that have come, in the driver's thread."""
        while self._came:
            self._came.popleft()()
        if self._failure is not None:
            failure, self._failure = self._failure, None
            raise failure from failure.cause

    def _receive(self) -> None:
        errors: Any = importlib.import_module("rclpy.executors")
        with suppress(errors.ExternalShutdownException, errors.ShutdownException):
            self._executor.spin()

    # Messages.

    def _profile(self, **settings: Any) -> Any:
        given = {"depth": 1, "durability": self._qos.DurabilityPolicy.TRANSIENT_LOCAL}
        return self._qos.QoSProfile(**{**given, **settings})

    def _converted(self, message: Message, class_: Any) -> Any:
        return self._serialization.deserialize_message(serialization.serialize(message), class_)

    def _bytes(self, message: Any) -> bytes:
        return self._serialization.serialize_message(message)

    def _read(self, data: bytes, class_: Any) -> Any:
        return serialization.Reader(data, self.application.classes.message).message(class_)

    def advertise(self, topic: str, type_name: str) -> Any:
        """Make the test application a publisher that fits every subscription."""
        if topic not in self._publishers:
            self._publishers[topic] = self._node.create_publisher(installed(type_name), topic, self._profile())
        return self._publishers[topic]

    def send(self, topic: str, type_name: str, message: Message) -> None:
        """Publish a message at the current time."""
        if self._clock_ns < self._now_ns - 1:
            # Clocks of the nodes show as good as now, but timers of this time come later.
            self._step(self._now_ns - 1)
        self._has_sent = True
        is_new = topic not in self._publishers
        publisher = self.advertise(topic, type_name)
        if is_new:
            # Discovery takes a moment, in which no simulated time passes.
            end_s = time.monotonic() + _MATCHED_AT_MOST_S
            while publisher.get_subscription_count() < self._node.count_subscribers(topic):
                if time.monotonic() > end_s:
                    break  # their quality of service does not fit
                time.sleep(0.001)
        publisher.publish(serialization.serialize(message))
        self._observed.fed(topic)

    def subscribe(self, topic: str, type_name: str, callback: Callable[[Any, int], None]) -> None:
        """Call back in the driver's thread with each message and the time when it came in ns."""
        class_ = self.application.classes.message(type_name)

        def take(message: bytes) -> None:
            self._came.append(lambda: callback(self._read(message, class_), self._now_ns))

        profile = self._profile(
            depth=1_000,
            durability=self._qos.DurabilityPolicy.VOLATILE,
            reliability=self._qos.ReliabilityPolicy.BEST_EFFORT,
        )
        self._node.create_subscription(installed(type_name), topic, take, profile, raw=True)

    # Services.

    def call(self, name: str, type_name: str, request: Message, respond: Callable[[Message], None]) -> bool:
        """Call a service; `respond` is called in the driver's thread. Return whether a node offers it."""
        class_ = installed(type_name)
        own = self.application.classes.message(type_name)
        if name not in self._clients:
            self._clients[name] = self._node.create_client(class_, name)
        client = self._clients[name]
        end_s = time.monotonic() + (0 if self._begun and self._ended else _END_AT_MOST_S)
        offered = any(name == service for service, _ in self._node.get_service_names_and_types())
        while offered and not client.service_is_ready() and time.monotonic() < end_s:
            time.sleep(0.001)
        if not client.service_is_ready():
            return False

        def take(future: Any) -> None:
            self._came.append(lambda: respond(self._read(self._bytes(future.result()), own.Response)))

        client.call_async(self._converted(request, class_.Request)).add_done_callback(take)
        return True

    def serve(self, name: str, type_name: str, ask: Ask) -> None:
        """Offer a service to the nodes; `ask` is called in the driver's thread."""
        class_ = installed(type_name)
        own = self.application.classes.message(type_name)

        async def take(request: Any, _: Any) -> Any:
            answered = self._task.Future(executor=self._executor)

            def respond(message: Message) -> None:
                answered.set_result(self._converted(message, class_.Response))
                self._executor.wake()

            read = self._read(self._bytes(request), own.Request)
            self._came.append(lambda: ask(self.next_number(), read, respond))
            return await answered

        profile = self._qos.qos_profile_services_default
        group: Any = importlib.import_module("rclpy.callback_groups").ReentrantCallbackGroup()
        self._node.create_service(class_, name, take, qos_profile=profile, callback_group=group)

    # Beginning and end.

    def _begin_nodes(self) -> None:
        if self._begun:
            return
        self._begun = True
        self._begin(self._main)
        end_s = time.monotonic() + _READY_AT_MOST_S
        found, since_s = self._observed.graph(), time.monotonic()
        while True:
            self._quiet.wait(_UNCHANGED_S)
            self._take()
            now, now_s = self._observed.graph(), time.monotonic()
            if now != found:
                found, since_s = now, now_s
            if self._ended or now_s - since_s >= (_UNCHANGED_S if self._is_connected() else _UNCONNECTED_S):
                break
            if now_s > end_s:
                self.unobserved.warn(f"the node was not ready after {_READY_AT_MOST_S:.0f} s")
                break
            time.sleep(0.005)
        self._due_s = time.monotonic()
        self._clock_ns = -_STEP_NS

    def _is_connected(self) -> bool:
        """Whether the nodes hear the clock, and all publishers and subscriptions of a topic have met."""
        node = self._node
        return (
            self._clock.get_subscription_count() > 0
            and all(s.get_publisher_count() >= node.count_publishers(s.topic_name) for s in node.subscriptions)
            and all(p.get_subscription_count() >= node.count_subscribers(p.topic_name) for p in node.publishers)
        )

    def _main(self) -> None:
        """Run the nodes; called in the main thread."""
        try:
            self._run()
        except (SystemExit, KeyboardInterrupt):
            pass  # as at the end of a process
        except Exception as e:
            if not self._ended and not is_regular_end(e):
                self._failure = NodeError("main", e)
        finally:
            self._ended = self._has_returned = True

    def end(self) -> None:
        """End the case: spin returns in the nodes, and what follows it runs."""
        if not self._context.ok():
            return
        self._observed.look()
        self._ended = True
        if not self._has_returned:
            self._application_ends()
        self._context.try_shutdown()
        self._receiver.join(_END_AT_MOST_S)
        self._quiet.close()

    def report(self) -> RosReport:
        """Return what the nodes did that nothing looked at."""
        return self._observed.report(self.unobserved.warnings())
