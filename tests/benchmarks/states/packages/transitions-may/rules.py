"""The contract of the door as a state machine of Hypothesis."""

from door import Door
from hypothesis.stateful import RuleBasedStateMachine, precondition, rule


class Rules(RuleBasedStateMachine):
    def __init__(self):
        super().__init__()
        self.door = Door()
        self.opened = False

    @precondition(lambda self: not self.opened)
    @rule()
    def open(self):
        self.door.open()
        self.opened = True

    @precondition(lambda self: self.opened)
    @rule()
    def close(self):
        self.door.close()
        self.opened = False

    @precondition(lambda self: self.opened)
    @rule()
    def note(self):
        self.door.note()

    @rule()
    def may_open(self):
        assert self.door.may_open() == (not self.opened)

    @rule()
    def may_note(self):
        assert self.door.may_note() == self.opened
