"""Clients of services."""

from __future__ import annotations

from typing import Any

from sitaf_ros import graph
from sitaf_ros.current import system

from .entity import QueueEntity
from .introspection import Introspection
from .task import Future


class Client(QueueEntity):
    def __init__(self, node: Any, srv_type: Any, srv_name: str, qos_profile: Any, group: Any) -> None:
        super().__init__(node, None, group)
        self.callback_name = f"client of {srv_name}"
        self.srv_type, self.srv_name, self.qos_profile = srv_type, srv_name, qos_profile
        self.context = node.context
        self._introspection = Introspection(node, srv_type, srv_name)
        self._pending: list[Future] = []
        self._calling = graph.Calling(srv_name, srv_type._full_name, node.get_fully_qualified_name())
        system().graph.clients.setdefault(srv_name, []).append(self._calling)

    @property
    def service_name(self) -> str:
        return self.srv_name

    def call_async(self, request: Any) -> Future:
        if not isinstance(request, self.srv_type.Request):
            raise TypeError(f"Expected {self.srv_type.Request}, got {type(request)}")
        future = Future()
        self._pending.append(future)
        self._calling.calls += 1
        current = system().graph

        def respond(response: Any) -> None:
            number = current.next_number()
            self.put(number, lambda: self._take_response(future, response, number))

        self._introspection.event(0, self._calling.calls, request=request)
        current.call(self.srv_name, self.srv_type._full_name, request, respond)
        return future

    def _take_response(self, future: Future, response: Any, number: int) -> None:
        self._introspection.event(3, number, response=response)
        if future in self._pending:
            self._pending.remove(future)
            if not future.cancelled():
                future._set_executor(self._node.executor)
                future.set_result(response)

    def call(self, request: Any, timeout_sec: float | None = None) -> Any:
        """Wait for the response; another thread must spin."""
        future = self.call_async(request)
        threads = system().threads
        me = threads.current()

        def done(_: Future) -> None:
            threads.wake(me)

        done.runs_at_once = True  # type: ignore[attr-defined]
        future.add_done_callback(done)
        deadline = None if timeout_sec is None else threads.now_ns + round(timeout_sec * 1e9)
        while not future.done():
            if not threads.wait(deadline) and not future.done():
                raise TimeoutError
        return future.result()

    def remove_pending_request(self, future: Future) -> None:
        if future in self._pending:
            self._pending.remove(future)

    def service_is_ready(self) -> bool:
        return system().graph.server(self.srv_name, self.srv_type._full_name) is not None

    def wait_for_service(self, timeout_sec: float | None = None) -> bool:
        return wait_until(self.service_is_ready, timeout_sec, self.context)

    def configure_introspection(self, clock: Any, service_event_qos_profile: Any, introspection_state: Any) -> None:
        self._introspection.configure(clock, service_event_qos_profile, introspection_state)

    def destroy(self) -> None:
        if not self.destroyed:
            super().destroy()
            system().graph.clients[self.srv_name].remove(self._calling)


def wait_until(ready: Any, timeout_sec: float | None, context: Any) -> bool:
    """Wait until something appears among the services and topics."""
    threads, current = system().threads, system().graph
    forever = timeout_sec is None or timeout_sec < 0
    end = None if forever else threads.now_ns + round((timeout_sec or 0) * 1e9)
    me = threads.current()
    while context.ok() and not ready():
        if end is not None and threads.now_ns >= end:
            threads.poll()
            break
        current.watchers.append(lambda: threads.wake(me))
        threads.wait(end, returns_at_end=True)
    return ready()
