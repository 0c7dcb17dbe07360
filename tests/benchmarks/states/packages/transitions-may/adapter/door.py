"""Adapts transitions.Machine to the interface Door."""

from transitions import Machine

TRANSITIONS = [["open", "closed", "opened"], ["close", "opened", "closed"], ["note", "opened", None]]


class Model:
    """What the machine gives a state."""


class Door:
    """A door that is open or closed."""

    def __init__(self) -> None:
        self._model = Model()
        self._machine = Machine(self._model, ["closed", "opened"], "closed", TRANSITIONS, auto_transitions=False)

    def open(self) -> None:
        self._model.trigger("open")

    def close(self) -> None:
        self._model.trigger("close")

    def note(self) -> None:
        self._model.trigger("note")

    def may_open(self) -> bool:
        return self._model.may_open()

    def may_note(self) -> bool:
        return self._model.may_note()
