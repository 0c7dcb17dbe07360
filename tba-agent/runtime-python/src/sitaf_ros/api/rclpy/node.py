"""Nodes."""

from __future__ import annotations

import weakref
from typing import Any

from sitaf_ros.current import message, note_later_release, system

from .callback_groups import CallbackGroup, MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from .client import Client
from .clock import Clock, ROSClock
from .event_handler import EndpointEvents
from .exceptions import InvalidHandle, NotInitializedException
from .guard_condition import GuardCondition
from .logger_service import LoggingService
from .logging import get_logger
from .node_graph import NodeGraph
from .node_parameters import NodeParameters
from .parameter_service import ParameterService
from .publisher import Publisher
from .qos import profile_of, qos_profile_rosout_default, qos_profile_services_default, quality_of
from .qos_overriding_options import override
from .service import Service
from .subscription import Subscription
from .timer import Rate, Timer, period_ns
from .type_support import check_is_valid_msg_type, check_is_valid_srv_type
from .utilities import apply_ros_arguments, get_default_context
from .validate_namespace import validate_namespace
from .validate_node_name import validate_node_name

HIDDEN_NODE_PREFIX = "_"


class NodeNameNonExistentError(RuntimeError):
    pass


class Node(NodeGraph, NodeParameters):
    PARAM_REL_TOL = 1e-6
    _ros_is_lifecycle = False

    def __init__(
        self,
        node_name: str,
        *,
        context: Any = None,
        cli_args: list[str] | None = None,
        namespace: str | None = None,
        use_global_arguments: bool = True,
        enable_rosout: bool = True,
        rosout_qos_profile: Any = qos_profile_rosout_default,
        start_parameter_services: bool = True,
        parameter_overrides: Any = None,
        allow_undeclared_parameters: bool = False,
        automatically_declare_parameters_from_overrides: bool = False,
        enable_logger_service: bool = False,
    ) -> None:
        self._context = get_default_context() if context is None else context
        if not self._context.ok():
            raise NotInitializedException("cannot create node")
        case = system()
        if cli_args is not None:
            apply_ros_arguments(cli_args)
        validate_node_name(node_name)
        settings, rules = case.settings, case.remapping
        only = settings.node_name if not case.node_list else None
        self._ros_name = only or rules.special("__node", node_name) or rules.special("__name", node_name) or node_name
        given = rules.special("__ns", node_name) or settings.namespace or namespace or ""
        self._ros_namespace = given if given.startswith("/") else f"/{given}"
        validate_namespace(self._ros_namespace)
        self._ros_entities: list[Any] = []
        self._ros_publishers: list[Publisher] = []
        self._ros_rates: list[Rate] = []
        self._ros_executor: Any = None
        self._ros_destroyed = False
        self._ros_default_group = MutuallyExclusiveCallbackGroup()
        self._ros_own_group = ReentrantCallbackGroup()
        self._logger = get_logger(self.get_fully_qualified_name().strip("/").replace("/", "."))
        self._clock = ROSClock()
        case.node_list.append(self)
        self._ros_begin_parameters(
            parameter_overrides or [], allow_undeclared_parameters, automatically_declare_parameters_from_overrides
        )
        if start_parameter_services:
            self._ros_parameter_service = ParameterService(self)
        if enable_logger_service:
            self._ros_logger_service = LoggingService(self)

    # Names.

    @property
    def context(self) -> Any:
        return self._context

    @property
    def handle(self) -> Any:
        if self._ros_destroyed:
            raise InvalidHandle("cannot use Destroyable because destruction was requested")
        return self

    def get_name(self) -> str:
        return self._ros_name

    def get_namespace(self) -> str:
        return self._ros_namespace

    def get_fully_qualified_name(self) -> str:
        return f"{self._ros_namespace.rstrip('/')}/{self._ros_name}"

    def get_logger(self) -> Any:
        return self._logger

    def get_clock(self) -> Clock:
        return self._clock

    def resolve_topic_name(self, topic: str, *, only_expand: bool = False) -> str:
        return self._ros_full_name(topic, only_expand)

    def resolve_service_name(self, service: str, *, only_expand: bool = False) -> str:
        return self._ros_full_name(service, only_expand)

    # Executors.

    @property
    def executor(self) -> Any:
        return None if self._ros_executor is None else self._ros_executor()

    @executor.setter
    def executor(self, new_executor: Any) -> None:
        current = self.executor
        if current is new_executor:
            return
        if current is not None:
            current.remove_node(self)
        self._ros_executor = None
        if new_executor is not None:
            self._ros_executor = weakref.ref(new_executor)
            new_executor.add_node(self)

    def _ros_wake(self) -> None:
        """Let the executor look for work."""
        executor = self.executor
        if executor is not None:
            executor.wake()

    def _ros_keep(self, entity: Any) -> None:
        """Add an entity to what the executor asks for work."""
        self._ros_entities.append(entity)
        self._ros_wake()

    def _ros_forget(self, entity: Any) -> None:
        """Remove an entity."""
        if entity in self._ros_entities:
            self._ros_entities.remove(entity)

    def _ros_forget_publisher(self, publisher: Publisher) -> None:
        """Remove a publisher."""
        if publisher in self._ros_publishers:
            self._ros_publishers.remove(publisher)

    @property
    def default_callback_group(self) -> CallbackGroup:
        return self._ros_default_group

    def _ros_group(self, group: CallbackGroup | None) -> CallbackGroup:
        return self.default_callback_group if group is None else group

    def _ros_of(self, kind: Any) -> Any:
        return iter([entity for entity in self._ros_entities if isinstance(entity, kind)])

    @property
    def publishers(self) -> Any:
        return iter(list(self._ros_publishers))

    @property
    def subscriptions(self) -> Any:
        return self._ros_of(Subscription)

    @property
    def clients(self) -> Any:
        return self._ros_of(Client)

    @property
    def services(self) -> Any:
        return self._ros_of(Service)

    @property
    def timers(self) -> Any:
        return self._ros_of(Timer)

    @property
    def guards(self) -> Any:
        return self._ros_of(GuardCondition)

    @property
    def waitables(self) -> Any:
        return iter(())

    def add_waitable(self, waitable: Any) -> None:
        """Actions are made of services and topics here, so nothing needs to be added."""

    def remove_waitable(self, waitable: Any) -> None:
        """See `add_waitable`."""

    # Making and destroying.

    def create_publisher(
        self,
        msg_type: Any,
        topic: str,
        qos_profile: Any,
        *,
        callback_group: CallbackGroup | None = None,
        event_callbacks: Any = None,
        qos_overriding_options: Any = None,
        publisher_class: Any = Publisher,
    ) -> Any:
        check_is_valid_msg_type(msg_type)
        full, profile = self._ros_full_name(topic), profile_of(qos_profile)
        if qos_overriding_options is not None:
            profile = override(self, "publisher", full, profile, qos_overriding_options)
        group = self._ros_group(callback_group)
        events = EndpointEvents(self, event_callbacks, group, full, False, quality_of(profile))
        publisher = publisher_class(self, msg_type, full, profile, events)
        self._ros_publishers.append(publisher)
        return publisher

    def create_subscription(
        self,
        msg_type: Any,
        topic: str,
        callback: Any,
        qos_profile: Any,
        *,
        callback_group: CallbackGroup | None = None,
        event_callbacks: Any = None,
        qos_overriding_options: Any = None,
        raw: bool = False,
    ) -> Subscription:
        check_is_valid_msg_type(msg_type)
        full, profile = self._ros_full_name(topic), profile_of(qos_profile)
        if qos_overriding_options is not None:
            profile = override(self, "subscription", full, profile, qos_overriding_options)
        group = self._ros_group(callback_group)
        quality = quality_of(profile, subscribes=True)
        events = EndpointEvents(self, event_callbacks, group, full, True, quality)
        subscription = Subscription(self, msg_type, full, callback, group, profile, raw, events)
        self._ros_keep(subscription)
        subscription.connect()
        return subscription

    def create_client(
        self,
        srv_type: Any,
        srv_name: str,
        *,
        qos_profile: Any = qos_profile_services_default,
        callback_group: CallbackGroup | None = None,
    ) -> Client:
        check_is_valid_srv_type(srv_type)
        client = Client(
            self, srv_type, self._ros_full_name(srv_name), profile_of(qos_profile), self._ros_group(callback_group)
        )
        self._ros_keep(client)
        return client

    def create_service(
        self,
        srv_type: Any,
        srv_name: str,
        callback: Any,
        *,
        qos_profile: Any = qos_profile_services_default,
        callback_group: CallbackGroup | None = None,
    ) -> Service:
        check_is_valid_srv_type(srv_type)
        group = self._ros_group(callback_group)
        service = Service(self, srv_type, self._ros_full_name(srv_name), callback, group, profile_of(qos_profile))
        self._ros_keep(service)
        return service

    def _ros_create_own_service(self, srv_type: Any, srv_name: str, callback: Any, qos_profile: Any) -> Service:
        """Make a service of rclpy itself, which runs whatever the user's groups do."""
        full = self._ros_full_name(srv_name)
        service = Service(self, srv_type, full, callback, self._ros_own_group, qos_profile, own=True)
        self._ros_keep(service)
        return service

    def create_timer(
        self,
        timer_period_sec: float,
        callback: Any,
        callback_group: CallbackGroup | None = None,
        clock: Clock | None = None,
        autostart: bool = True,
    ) -> Timer:
        period = period_ns(timer_period_sec)
        timer = Timer(self, callback, self._ros_group(callback_group), period, clock or self._clock, autostart)
        self._ros_keep(timer)
        return timer

    def create_guard_condition(self, callback: Any, callback_group: CallbackGroup | None = None) -> GuardCondition:
        guard = GuardCondition(self, callback, self._ros_group(callback_group))
        self._ros_keep(guard)
        return guard

    def create_rate(self, frequency: float, clock: Clock | None = None) -> Rate:
        if frequency <= 0:
            raise ValueError("frequency must be > 0")
        rate = Rate(self, int(1_000_000_000 / frequency))
        self._ros_rates.append(rate)
        return rate

    def destroy_publisher(self, publisher: Publisher) -> bool:
        found = publisher in self._ros_publishers
        publisher.destroy()
        return found

    def _ros_destroy(self, entity: Any) -> bool:
        found = entity in self._ros_entities
        if found:
            entity.destroy()
        return found

    def destroy_subscription(self, subscription: Subscription) -> bool:
        return self._ros_destroy(subscription)

    def destroy_client(self, client: Client) -> bool:
        return self._ros_destroy(client)

    def destroy_service(self, service: Service) -> bool:
        return self._ros_destroy(service)

    def destroy_timer(self, timer: Timer) -> bool:
        return self._ros_destroy(timer)

    def destroy_guard_condition(self, guard: GuardCondition) -> bool:
        return self._ros_destroy(guard)

    def destroy_rate(self, rate: Rate) -> bool:
        found = rate in self._ros_rates
        if found:
            self._ros_rates.remove(rate)
            rate.destroy()
        return found

    def destroy_node(self) -> None:
        if self._ros_destroyed:
            return
        self._ros_destroyed = True
        for publisher in list(self._ros_publishers):
            publisher.destroy()
        for entity in list(self._ros_entities):
            entity.destroy()
        executor = self.executor
        if executor is not None:
            executor.remove_node(self)
        if self in system().node_list:
            system().node_list.remove(self)

    def __enter__(self) -> Node:
        note_later_release("with on a node")
        return self

    def __exit__(self, *_: object) -> None:
        self.destroy_node()

    def _ros_full_name(self, name: str, only_expand: bool = False) -> str:
        from .expand_topic_name import expand_topic_name
        from .validate_topic_name import validate_topic_name

        validate_topic_name(name)
        if only_expand:
            return expand_topic_name(name, self._ros_name, self._ros_namespace)
        return system().remapping.apply(name, self._ros_name, self._ros_namespace)

    def _ros_parameter_event(self, new: list[Any], changed: list[Any], deleted: list[Any]) -> None:
        event = message("rcl_interfaces/msg/ParameterEvent")(node=self.get_fully_qualified_name())
        event.stamp = self._clock.now().to_msg()
        event.new_parameters = [p.to_parameter_msg() for p in new]
        event.changed_parameters = [p.to_parameter_msg() for p in changed]
        event.deleted_parameters = [p.to_parameter_msg() for p in deleted]
        self._ros_parameter_events.publish(event)
