"""Callback groups say which callbacks may run at the same time."""

from __future__ import annotations

import weakref
from typing import Any

from sitaf_ros.current import node_threads


class CallbackGroup:
    def __init__(self) -> None:
        self.entities: set[Any] = set()

    def add_entity(self, entity: Any) -> None:
        self.entities.add(weakref.ref(entity))

    def has_entity(self, entity: Any) -> bool:
        return weakref.ref(entity) in self.entities

    def can_execute(self, entity: Any) -> bool:
        raise NotImplementedError

    def beginning_execution(self, entity: Any) -> bool:
        raise NotImplementedError

    def ending_execution(self, entity: Any) -> None:
        raise NotImplementedError


class ReentrantCallbackGroup(CallbackGroup):
    def can_execute(self, entity: Any) -> bool:
        return True

    def beginning_execution(self, entity: Any) -> bool:
        return True

    def ending_execution(self, entity: Any) -> None:
        pass


class MutuallyExclusiveCallbackGroup(CallbackGroup):
    """One callback at a time; a nested spin in a callback runs others of its group, but never the callback itself."""

    def __init__(self) -> None:
        super().__init__()
        self._active: list[Any] = []

    def can_execute(self, entity: Any) -> bool:
        if not self._active:
            return True
        threads = node_threads()
        me = None if threads is None else threads.current()
        return entity not in self._active and all(active.running_in is me for active in self._active)

    def beginning_execution(self, entity: Any) -> bool:
        if not self.can_execute(entity):
            return False
        self._active.append(entity)
        return True

    def ending_execution(self, entity: Any) -> None:
        if entity in self._active:
            self._active.remove(entity)
