"""The contract of the bus as a state machine of Hypothesis."""

from bus import Bus
from hypothesis.stateful import RuleBasedStateMachine, precondition, rule


class Rules(RuleBasedStateMachine):
    def __init__(self):
        super().__init__()
        self.bus = Bus()
        self.listens = self.once = False

    @precondition(lambda self: not self.listens)
    @rule()
    def add_listener(self):
        self.bus.add_listener()
        self.listens = True

    @precondition(lambda self: self.listens)
    @rule()
    def remove_listener(self):
        self.bus.remove_listener()
        self.listens = False

    @precondition(lambda self: not self.once)
    @rule()
    def add_once(self):
        self.bus.add_once()
        self.once = True

    @precondition(lambda self: self.once)
    @rule()
    def remove_once(self):
        self.bus.remove_once()
        self.once = False

    @rule()
    def emit(self):
        called = self.bus.emit()
        assert called == self.listens + self.once
        self.once = False
