"""The contract of the controller as a state machine of Hypothesis."""

from hypothesis import strategies
from hypothesis.stateful import RuleBasedStateMachine, precondition, rule
from switched_controller import SwitchedController


class Rules(RuleBasedStateMachine):
    def __init__(self):
        super().__init__()
        self.controller = SwitchedController()
        self.is_on, self.integral, self.waited = True, 0.0, 0.0

    @rule()
    def wait(self):
        self.controller.wait()
        self.waited += self.is_on

    @precondition(lambda self: self.is_on)
    @rule()
    def off(self):
        self.controller.off()
        self.is_on = False

    @precondition(lambda self: not self.is_on)
    @rule()
    def on(self):
        self.controller.on()
        self.is_on, self.integral, self.waited = True, 0.0, 0.0

    @precondition(lambda self: self.is_on and self.waited > 0)
    @rule(measured=strategies.sampled_from([0.0, 3.0]))
    def update(self, measured):
        self.integral += (1.0 - measured) * self.waited
        self.waited = 0.0
        assert self.controller.update(measured) == 2.0 * (1.0 - measured) + self.integral
