"""The contract of the task as a state machine of Hypothesis."""

from hypothesis.stateful import RuleBasedStateMachine, precondition, rule
from task import Task
from transitions import MachineError


class Rules(RuleBasedStateMachine):
    def __init__(self):
        super().__init__()
        self.task = Task()
        self.state = "idle"

    def call(self, method, allowed, after):
        if allowed:
            self.state = after
            assert method() == after
        else:
            try:
                method()
            except MachineError:
                return
            raise AssertionError("no error")

    @rule()
    def start(self):
        self.call(self.task.start, self.state == "idle", "work_near")

    @rule()
    def swap(self):
        self.call(self.task.swap, self.state != "idle", "work_far" if self.state == "work_near" else "work_near")

    @rule()
    def stop(self):
        self.call(self.task.stop, self.state != "idle", "idle")

    @rule()
    def again(self):
        assert self.task.again() == self.state
