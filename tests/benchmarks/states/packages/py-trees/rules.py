"""The contract of the sequence of behaviours as a state machine of Hypothesis."""

from behaviour_sequence import BehaviourSequence
from hypothesis import strategies
from hypothesis.stateful import RuleBasedStateMachine, rule

STATUS = strategies.sampled_from(["SUCCESS", "RUNNING", "FAILURE"])


class Rules(RuleBasedStateMachine):
    def __init__(self):
        super().__init__()
        self.tree = BehaviourSequence()
        self.children = ["SUCCESS"] * 3
        self.running = 0

    @rule(status=STATUS)
    def first(self, status):
        self.tree.first(status)
        self.children[0] = status

    @rule(status=STATUS)
    def second(self, status):
        self.tree.second(status)
        self.children[1] = status

    @rule(status=STATUS)
    def third(self, status):
        self.tree.third(status)
        self.children[2] = status

    @rule()
    def tick(self):
        begin = max(self.running, 1)
        stops = [i for i in range(begin, 4) if self.children[i - 1] != "SUCCESS"]
        last = stops[0] if stops else 3
        status = self.children[last - 1] if stops else "SUCCESS"
        assert self.tree.tick() == (status, last - begin + 1)
        self.running = last if status == "RUNNING" else 0

    @rule()
    def interrupt(self):
        self.tree.interrupt()
        self.running = 0
