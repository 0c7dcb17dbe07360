"""What publishers, subscriptions, timers, services and clients have in common for executors."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from typing import Any

from sitaf_ros.callback_names import callback_name, is_of_user
from sitaf_ros.current import note_later_release, system

Order = tuple[int, int]
Work = Callable[[], Any]
MESSAGES, TIMERS = 0, 1


class Entity:
    """Something that an executor asks for work."""

    callback_group: Any

    def __class_getitem__(cls, item: Any) -> Any:
        """Annotations may name a type: `Subscription[String]`."""
        return cls

    def __init__(self, node: Any, callback: Any, callback_group: Any, prefix: str = "") -> None:
        self._node = node
        self.callback_group = callback_group
        self.callback_name = prefix or ("" if callback is None else callback_name(callback))
        self.running_in: Any = None
        self.destroyed = False
        if callback_group is not None:
            callback_group.add_entity(self)
        if callback is not None and not prefix and is_of_user(callback):
            system().unobserved.callback(self.callback_name)

    def order(self) -> Order | None:
        """Return the place among what is ready, or None if nothing is."""
        return None

    def due_ns(self) -> int | None:
        """Return when it becomes ready by itself."""
        return None

    def take(self) -> Work | None:
        """Return the work to do."""
        return None

    @property
    def handle(self) -> Any:
        """Return the entity: there is no C object behind it."""
        return self

    def destroy(self) -> None:
        """Take it out of its node."""
        self.destroyed = True
        self._node._ros_forget(self)

    def __enter__(self) -> Any:
        note_later_release(f"with on a {type(self).__name__.lower()}")
        return self

    def __exit__(self, *_: object) -> None:
        self.destroy()


class QueueEntity(Entity):
    """An entity with a queue of work, each with its place in the order of events."""

    def __init__(self, node: Any, callback: Any, callback_group: Any, prefix: str = "") -> None:
        super().__init__(node, callback, callback_group, prefix)
        self.queue: deque[tuple[int, Work]] = deque()

    def put(self, number: int, work: Work) -> None:
        """Add work and wake the executor."""
        self.queue.append((number, work))
        self._node._ros_wake()

    def order(self) -> Order | None:
        return (MESSAGES, self.queue[0][0]) if self.queue and not self.destroyed else None

    def take(self) -> Work | None:
        return self.queue.popleft()[1] if self.queue else None
