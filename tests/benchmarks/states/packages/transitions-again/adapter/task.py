"""Adapts transitions.extensions.HierarchicalMachine to the interface Task."""

from transitions.extensions import HierarchicalMachine

STATES = ["idle", {"name": "work", "children": ["near", "far"], "initial": "near"}]
TRANSITIONS = [
    ["start", "idle", "work"],
    ["swap", "work_near", "work_far"],
    ["swap", "work_far", "work_near"],
    ["stop", "work", "idle"],
    ["again", "*", "="],
]


class Model:
    """What the machine gives a state."""


class Task:
    """A machine with nested states."""

    def __init__(self) -> None:
        self._model = Model()
        self._machine = HierarchicalMachine(
            self._model, states=STATES, transitions=TRANSITIONS, initial="idle", auto_transitions=False
        )

    def start(self) -> str:
        return self._trigger("start")

    def swap(self) -> str:
        return self._trigger("swap")

    def stop(self) -> str:
        return self._trigger("stop")

    def again(self) -> str:
        return self._trigger("again")

    def _trigger(self, name: str) -> str:
        self._model.trigger(name)
        return self._model.state
