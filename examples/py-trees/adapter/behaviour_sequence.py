"""Adapts py_trees.composites.Sequence to the interface BehaviourSequence."""

from py_trees.behaviour import Behaviour
from py_trees.common import Status
from py_trees.composites import Sequence


class Child(Behaviour):
    """A behaviour that returns a status that is set from outside."""

    def __init__(self, name: str) -> None:
        super().__init__(name)
        self.next = Status.SUCCESS

    def update(self) -> Status:
        """Return the status that was set last."""
        return self.next


class BehaviourSequence:
    """Three behaviours in a sequence."""

    def __init__(self) -> None:
        self._children = [Child(name) for name in ("first", "second", "third")]
        self._sequence = Sequence("sequence")
        self._sequence.add_children(self._children)

    def first(self, status: str) -> None:
        self._children[0].next = Status[status]

    def second(self, status: str) -> None:
        self._children[1].next = Status[status]

    def third(self, status: str) -> None:
        self._children[2].next = Status[status]

    def tick(self) -> tuple[str, int]:
        """Tick the tree; return the status of the sequence and the number of ticked behaviours."""
        nodes = list(self._sequence.tick())
        return self._sequence.status.name, len(nodes) - nodes.count(self._sequence)

    def interrupt(self) -> None:
        """Stop the sequence."""
        self._sequence.stop(Status.INVALID)
