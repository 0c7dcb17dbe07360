"""Guard conditions."""

from __future__ import annotations

from typing import Any

from sitaf_ros.current import system

from .entity import QueueEntity


class GuardCondition(QueueEntity):
    def __init__(self, node: Any, callback: Any, callback_group: Any) -> None:
        super().__init__(node, callback, callback_group)
        self.callback = callback

    def trigger(self) -> None:
        if not self.queue:
            self.put(system().graph.next_number(), lambda: None if self.callback is None else self.callback())
