"""The contract of the lights as a state machine of Hypothesis."""

from hypothesis.stateful import RuleBasedStateMachine, precondition, rule
from lights import Lights


class Rules(RuleBasedStateMachine):
    def __init__(self):
        super().__init__()
        self.lights = Lights()
        self.two = False

    @precondition(lambda self: not self.two)
    @rule()
    def add_second(self):
        self.lights.add_second()
        self.two = True

    @rule()
    def switch_first(self):
        assert self.lights.switch_first() == "first"

    @precondition(lambda self: self.two)
    @rule()
    def switch_second(self):
        assert self.lights.switch_second() == "second"
