"""What the test application does with the nodes of a case: messages, services and actions.

The same for the API that comes along and for an installed ROS 2; each says how messages and calls travel.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from sitaf_ros import conversion
from sitaf_ros.action_test import ActionAnswer, GoalUnderTest, serve_action
from sitaf_ros.messages import Message
from sitaf_ros.unobserved import Unobserved

if TYPE_CHECKING:
    from sitaf_ros.application import RosApplication
    from sitaf_ros.settings import RosSettings

Ask = Callable[[int, Any, Callable[[Message], None]], None]
"""Takes the number of a call, the request, and what to call with the response."""


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


@dataclass(order=True)
class _Later:
    time_ns: int
    number: int
    act: Callable[[], None] = field(compare=False)


class TestSide(ABC):
    """The driver's side of a case; all methods are for the driver's thread. Names of topics and services are full."""

    def __init__(self, application: RosApplication, settings: RosSettings) -> None:
        self.application = application
        self.settings = settings
        self.unobserved = Unobserved()
        self._planned: list[_Later] = []

    # How messages, calls and time pass.

    @property
    @abstractmethod
    def now_ns(self) -> int:
        """Simulation time since the nodes were made."""

    @abstractmethod
    def ros_time_ns(self) -> int:
        """Return what ROS clocks of the nodes show."""

    @abstractmethod
    def next_number(self) -> int:
        """Return the next number of an event or a goal."""

    @abstractmethod
    def advertise(self, topic: str, type_name: str) -> Any:
        """Make the test application a publisher that fits every subscription."""

    @abstractmethod
    def send(self, topic: str, type_name: str, message: Message) -> None:
        """Publish a message at the current time."""

    @abstractmethod
    def subscribe(self, topic: str, type_name: str, callback: Callable[[Any, int], None]) -> None:
        """Call back in the driver's thread with each message and its time of publication in ns."""

    @abstractmethod
    def call(self, name: str, type_name: str, request: Message, respond: Callable[[Message], None]) -> bool:
        """Call a service; `respond` is called in the driver's thread. Return whether a node offers it."""

    @abstractmethod
    def serve(self, name: str, type_name: str, ask: Ask) -> None:
        """Offer a service to the nodes; `ask` is called in the driver's thread."""

    def later(self, seconds: float, act: Callable[[], None]) -> None:
        """Do something for the test side after a time."""
        self._planned.append(_Later(self.now_ns + max(0, round(seconds * 1e9)), self.next_number(), act))
        self._planned.sort()

    def next_planned_ns(self) -> int | None:
        """Return when the next of these is due; None for never."""
        return self._planned[0].time_ns if self._planned else None

    def do_planned(self) -> bool:
        """Do what is due now; return whether there was something."""
        is_due = False
        while self._planned and self._planned[0].time_ns <= self.now_ns:
            is_due = True
            self._planned.pop(0).act()
        return is_due

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

    def publish(self, topic: str, type_name: str, fields: Mapping[str, Any] | Message, stamp: bool = True) -> None:
        """Publish at the current time; a stamp of a header that is not named is the time of publication."""
        message = self.new_message(type_name, fields)
        if stamp and isinstance(fields, Mapping):
            self._stamp(message, fields)
        self.send(full(topic), type_name, message)

    def _stamp(self, message: Any, fields: Any) -> None:
        """Set the stamps of the headers in a message that `fields` does not name."""
        named = fields if isinstance(fields, Mapping) else {}
        for name, type_name in message._fields_and_field_types.items():
            part, given = getattr(message, name), named.get(name)
            if type_name == "std_msgs/Header":
                if not (isinstance(given, Mapping) and "stamp" in given):
                    part.stamp.sec, part.stamp.nanosec = divmod(self.ros_time_ns(), 10**9)
            elif hasattr(part, "_fields_and_field_types"):
                self._stamp(part, given)
            elif isinstance(part, list | tuple) and isinstance(given, list | tuple):
                for element, values in zip(part, given, strict=False):
                    if hasattr(element, "_fields_and_field_types"):
                        self._stamp(element, values)

    # Services and actions.

    def call_service(
        self, name: str, type_name: str, fields: Mapping[str, Any] | Message, then: Callable[[Any], None] | None = None
    ) -> ServiceCall:
        """Call a service of the nodes; run time until the call is done."""
        service = self.application.classes.message(type_name)
        call = ServiceCall(then=then)
        request = conversion.from_fields(self.application.classes, service.Request._definition.name, fields)
        if not self.call(full(name), type_name, request, call.finish):
            call.error = f"no node offers the service {full(name)} of type {type_name}"
        return call

    def serve_service(self, name: str, type_name: str, answer: Callable[[Any], Any]) -> None:
        """Answer a service for the nodes; `answer` returns a response, or `Delayed`; an exception is no answer."""
        service = self.application.classes.message(type_name)
        response_name = service.Response._definition.name

        def reply(_: int, request: Message, respond: Callable[[Message], None]) -> None:
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

        self.serve(full(name), type_name, reply)

    def send_goal(
        self,
        name: str,
        type_name: str,
        fields: Mapping[str, Any] | Message,
        feedback: Callable[[Any, int], None] | None = None,
    ) -> GoalUnderTest:
        """Send a goal to an action server of the nodes."""
        return GoalUnderTest(self, full(name), type_name, fields, feedback)

    def serve_action(self, name: str, type_name: str, answer: Callable[[Any], ActionAnswer]) -> None:
        """Be an action server for the nodes."""
        serve_action(self, full(name), type_name, answer)


def full(name: str) -> str:
    """Return a name with its leading slash."""
    return name if name.startswith("/") else f"/{name}"
