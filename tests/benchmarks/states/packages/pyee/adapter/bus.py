"""Adapts pyee.EventEmitter to the interface Bus."""

from pyee import EventEmitter


class Bus:
    """Counts the calls of its listeners."""

    def __init__(self) -> None:
        self._emitter = EventEmitter()
        self._called = 0

    def add_listener(self) -> None:
        self._emitter.on("event", self._listener)

    def remove_listener(self) -> None:
        self._emitter.remove_listener("event", self._listener)

    def add_once(self) -> None:
        self._emitter.once("event", self._once)

    def remove_once(self) -> None:
        self._emitter.remove_listener("event", self._once)

    def emit(self) -> int:
        self._called = 0
        self._emitter.emit("event")
        return self._called

    def _listener(self) -> None:
        self._called += 1

    def _once(self) -> None:
        self._called += 1
