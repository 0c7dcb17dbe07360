"""Services."""

from __future__ import annotations

import inspect
from typing import Any

from sitaf_ros import graph
from sitaf_ros.current import system

from .entity import QueueEntity
from .introspection import Introspection


class Service(QueueEntity):
    def __init__(
        self, node: Any, srv_type: Any, srv_name: str, callback: Any, group: Any, qos_profile: Any, own: bool = False
    ) -> None:
        super().__init__(node, callback, group, prefix=srv_name if own else "")
        self.srv_type, self.srv_name, self.callback, self.qos_profile = srv_type, srv_name, callback, qos_profile
        self._introspection = Introspection(node, srv_type, srv_name)
        self._server = graph.Server(srv_name, srv_type._full_name, self._ask, node.get_fully_qualified_name())
        system().graph.add_server(self._server)

    @property
    def service_name(self) -> str:
        return self.srv_name

    def _ask(self, number: int, request: Any, respond: Any) -> None:
        self.put(number, lambda: self._answer(number, request, respond))

    def _answer(self, number: int, request: Any, respond: Any) -> Any:
        self._introspection.event(1, number, request=request)
        result = self.callback(request, self.srv_type.Response())
        if inspect.iscoroutine(result):
            return self._finish(result, number, respond)
        self._send(result, number, respond)
        return None

    async def _finish(self, coroutine: Any, number: int, respond: Any) -> None:
        self._send(await coroutine, number, respond)

    def _send(self, response: Any, number: int, respond: Any) -> None:
        if response is None and isinstance(self.callback, NoReply):
            return
        self.send_response(response, respond)
        self._introspection.event(2, number, response=response)

    def send_response(self, response: Any, header: Any) -> None:
        if not isinstance(response, self.srv_type.Response):
            raise TypeError(
                f"{self.srv_name}: the callback must return a {self.srv_type.__name__}.Response, not {response!r}"
            )
        header(response)

    def configure_introspection(self, clock: Any, service_event_qos_profile: Any, introspection_state: Any) -> None:
        self._introspection.configure(clock, service_event_qos_profile, introspection_state)

    def destroy(self) -> None:
        if not self.destroyed:
            super().destroy()
            system().graph.remove_server(self._server)


class NoReply:
    """Marks a callback that answers by itself, later."""

    def __init__(self, callback: Any) -> None:
        self._callback = callback
        self.__qualname__ = getattr(callback, "__qualname__", type(callback).__qualname__)

    def __call__(self, request: Any, response: Any) -> Any:
        return self._callback(request, response)
